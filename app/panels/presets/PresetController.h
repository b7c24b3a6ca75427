// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/panels/presets/OwnPresetController.h"
#include "widgets/controls/MessageBar.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

class QAction;
class QMenu;

namespace limn {

class PresetBrowser;
class Volume;
struct WindowContext;

/// Lists presets and uses them in a session, built-in ones and the user's own.
class PresetController : public QObject {
  Q_OBJECT

public:
  explicit PresetController(WindowContext& context);

  /// Lists the presets and marks the one in use.
  PresetBrowser& browser() const { return m_browser; }

  /// Reads the user's own anew, and lists them.
  void refresh() { m_own.read(); }
  /// What was opened does not say which preset it was made from: that is the one whose look it has, or else
  /// whose curve.
  void recognise();
  /// Marks the preset that the scene was made from, and whether it was changed since. A preview goes on where
  /// only the camera moved.
  void markShown();

  /// All presets as they are shown of the volume that is open, in the order of the list.
  std::vector<Preset> fittedPresets() const;

  /// Whether a look is a preset that has numbers of its own, and its curve lies elsewhere: it was moved onto
  /// the values of the volume that is open.
  bool isFitted(const Preset& look) const;
  /// Those of `fittedPresets` of which that holds, by name.
  std::vector<std::string> namesOfFitted() const;

  /// What the look that is shown is called: the preset in use, marked as the user's where it was changed.
  QString nameShown() const;

  /// Who knows of something that presets shape in the place of the whole scene: the scene with its part made
  /// as a preset has it, or nothing where there is none at present.
  void setShownAs(std::function<std::optional<Scene>(const Preset&)> shownAs) {
    m_shownAs = std::move(shownAs);
  }

  void use(const QString& name);
  /// Shows a preset for a while; an empty name ends that.
  void preview(const QString& name);
  /// Has a preset compared with what is shown, by the model of a side (0 left, 1 right).
  void compare(const QString& name, int likeSide);
  /// Fills a menu with the presets for the picture of a side, 0 left or the only one, 1 right: a chosen one
  /// is used there, or compared with the scene's own look where the other side shows that. That which the
  /// picture shows is ticked, unless it was modified.
  void fillMenu(QMenu& menu, int side);
  /// The preset of this number (from 1 on) in the list; 0 is the full range of values.
  void useNumber(int number);

  void setFavourite(const QString& name, bool isFavourite);

  /// A preset as it is put into use: without its light where the user keeps their own.
  Preset asUsed(Preset preset) const;

signals:
  void exportRequested(const QString& preset);
  void listed();     ///< the list was made anew
  void inUseNamed(); ///< the preset in use may be another, or called otherwise, of the same scene
  /// What picture and curve are to show for a while, and the preset that it is a preview of; without one it
  /// is the session's own scene again. It enters no history.
  void previewed(const limn::Scene& scene, const std::string& preset);
  /// With what is shown, by the model of the picture at this side, 0 left or the only one, 1 right.
  void compareRequested(const limn::Preset& look, int likeSide);
  void ownCompareRequested(); ///< what is shown, with what becomes of it; the picture at the left stays

private:
  /// What a sentence about a preset is about: the one in use and the curves that are shown.
  struct Curves {
    std::string preset; ///< empty: none
    TransferFunction ofScene;
    std::vector<TransferFunction> ofLabels;
    bool operator==(const Curves&) const = default;
  };
  struct Said {
    QString sentence;
    Curves of;
  };

  void connectBrowser();
  void list();
  void addKeepingLight();
  void useOnSide(const QString& name, int side);
  std::string unmodifiedOf(int side) const;
  void show(const Preset& preset, const QString& edit);
  bool isInOtherUnits(const Preset& preset) const;
  bool isBuiltIn(const QString& name) const;
  void offerToFit(const Preset& preset);
  void offerWhereNothingShows(const Preset& preset);
  void sayHowItWasFitted(const Preset& preset);
  /// Says that one's own preset was fitted, and offers its own values.
  void offerAsSaved(const Preset& preset);
  void say(const QString& sentence, const MessageBar::Action& action = {});
  const Preset* find(const QString& name) const;
  std::optional<Preset> fitted(const QString& name) const;
  Curves curvesShown() const;
  void showStanding();
  void goOnWithPreview();

  WindowContext& m_context;
  PresetBrowser& m_browser;
  QAction* m_keepsLight = nullptr;
  std::function<std::optional<Scene>(const Preset&)> m_shownAs = [](const Preset&) { return std::nullopt; };
  OwnPresetController m_own;
  std::vector<Preset> m_builtIn = builtInPresets();
  std::shared_ptr<const Volume> m_volume; ///< that the list is ordered for
  QString m_previewed;                    ///< what is seen for a while; empty: nothing
  Scene m_previewedFrom;                  ///< the session's, then
  std::optional<Said> m_said;             ///< in the message bar, until the curves are others
};

} // namespace limn
