// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/picture/ComparisonState.h"
#include "io/scenefile/SessionFile.h"
#include "scene/light/LightPresets.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

class QAction;
class QActionGroup;
class QMenu;

namespace limn {

struct ComparedLook;
struct WindowContext;

/// What is compared, and in which layout: two models, chosen by buttons and in the pictures and shown by
/// both, or the scene's own look with another: a preset, or the one remembered as "before" (the snapshot).
class ComparisonController : public QObject {
  Q_OBJECT
  Q_MOC_INCLUDE(<QMenu>)

public:
  explicit ComparisonController(WindowContext& context);

  /// Two models beside each other as long as they have room: beside slices, or where each would be narrower
  /// than 400 pixels, there is one picture.
  void begin();

  /// A layout that somebody asks for; it holds however little room there is.
  void setLayout(CompareLayout layout);

  /// The same, chosen by the user. One picture that takes the place of two shows the model of that side in
  /// which the user worked last, at first the left; of two looks, as the right one shows it. One undo step
  /// with the layout where that is another model than the scene's. The pair stays for the way back.
  void chooseLayout(CompareLayout layout);

  /// The model of a side (0 left, 1 right) of a comparison; of a single picture, and of the scene's own look
  /// where no other shows it, the scene's. An undo step in any case.
  void setSideModel(int side, ShadingModel model);

  /// A whole light was chosen. Any but *Physical* leaves physical light at the right, whoever chose that.
  void followLight(LightPreset light);

  /// Shows a look at the left and the scene's own at the right, side by side where there was one picture.
  /// A look takes no model along: it is shown by that of a side, 0 the left, which keeps its own, or 1; only
  /// the snapshot always by that of the right. An undo step, unless it is the snapshot.
  void compareWith(const Preset& look, int likeSide = 0) { compare(look, {}, likeSide); }

  /// The same with the scene's own look as it is, which stays at the left with its model while another is
  /// chosen for the right.
  void compareOwn();

  /// What is at the left stands at the right from now on, and the other way round: models, or looks with
  /// their names, of which that at the right becomes the scene's own. One undo step. Nothing of one picture.
  void swapSides();

  /// The look that is compared with the scene's own, unless models are.
  std::optional<ComparedLook> comparedLook() const;

  /// The look remembered as "before", of the volume that is open.
  const std::optional<Preset>& remembered() const { return m_snapshot; }

  /// Tells presets whose curve was moved onto the values of the volume, as their names then say.
  void setIsFitted(std::function<bool(const Preset&)> isFitted) { m_isFitted = std::move(isFitted); }

  /// A scene has been opened: a picture that tells its sides is shown with those, an unlit image (imageLook)
  /// alone. What is opened after either has the layout from before, unless someone chose one meanwhile.
  void showOpened(const std::optional<ShownSides>& sides);

  /// Shows models or looks and layout of the moment. Nothing of another volume is compared.
  void show();

  /// What it knows, for the controller of a window that takes this one's place.
  struct Memory {
    ComparisonState compared;
    std::optional<Preset> snapshot;
    double wipe = 0.5;
    std::optional<int> workedIn;
    std::optional<std::pair<CompareLayout, bool>> beforeOpened;
    std::shared_ptr<ComparisonController*> shower;
    CompareLayout shown = CompareLayout::single;
  };
  Memory memory() const;
  /// Of the same volume, which is shown already; from now on this shows what undo steps of before lead to.
  void takeOver(const Memory& memory);

  /// Layout, models, looks and border in a session file.
  void describe(SessionDocument& session) const;
  void restore(const SessionDocument& session);

signals:
  /// The models on screen, from left to right, and the name of a look at the left that keeps its own light.
  void modelsShown(const std::vector<limn::ShadingModel>& models, const QString& keptLook);
  void shown();
  void layoutChosen(); ///< by the user
  /// A menu opens that offers presets for a side, 0 left or the only one, 1 right; it is to be filled.
  void presetMenuAsked(QMenu* menu, int side);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  /// `from` is the preset that the look was made from, where it was changed since.
  void compare(const Preset& look, const std::optional<Preset>& from, int likeSide = 0);
  /// What has changed since `before` is an undo step from now on.
  void note(const ComparisonState& before, const QString& text);
  /// Shows one of the two states between which a step leads; the layout where the step changed it.
  void showCompared(const ComparisonState& wanted, const ComparisonState& other);
  /// The same of a step that swaps two models.
  void showSwapped(const ComparisonState& wanted, const ComparisonState& other);
  void turnWorkedIn(); ///< it is the other side
  void followModel(const Scene& scene);
  QString ownName() const; ///< of the preset in use; empty where there is none
  void showOneOfBoth(ShadingModel model);
  CompareLayout layoutWithRoom() const;
  void fitLayout();
  void noteSlices();
  void addLayouts();
  void addModels();
  void addSnapshot();
  void takeSnapshot();
  void compareModels();

  WindowContext& m_context;
  QActionGroup* m_layouts;              ///< data: CompareLayout as int
  bool m_hasSlices = false;             ///< beside the picture
  QAction* m_compareSnapshot = nullptr; ///< checked while the snapshot is compared with what is shown
  QAction* m_compareModels = nullptr;   ///< enabled while looks are compared
  QAction* m_swap = nullptr;            ///< enabled while there are two pictures
  ComparisonState m_compared;
  std::optional<Preset> m_snapshot;
  std::function<bool(const Preset&)> m_isFitted = [](const Preset&) { return false; };
  std::optional<int> m_workedIn; ///< the side of two models: 0 left, 1 right; absent where in neither yet
  bool m_hasPhysical = false;    ///< the scene
  std::shared_ptr<const Volume> m_volume; ///< that they belong to
  /// What was wanted, and whether somebody asked for it, while what was opened brings a layout of its own.
  std::optional<std::pair<CompareLayout, bool>> m_beforeOpened;
  /// Who shows what undo steps lead to, which outlive this where another window takes their session over.
  std::shared_ptr<ComparisonController*> m_shower = std::make_shared<ComparisonController*>(this);
};

} // namespace limn
