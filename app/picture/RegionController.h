// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/sources/KeptRegion.h"
#include "app/picture/RegionOffers.h"
#include "scene/Scene.h"
#include "scene/regions/LabelFigures.h"
#include "widgets/Gesture.h"
#include "widgets/controls/BackgroundWork.h"
#include "widgets/controls/MessageBar.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QAction;

namespace limn {

struct WindowContext;

/// What is kept of the volume: the body, which it finds, or the labels of a segmentation, which it reads, and
/// what of these is cut away by hand, on a thread of its own, one at a time. What it makes becomes an undo
/// step. Another volume ends its work.
class RegionController : public QObject {
  Q_OBJECT

public:
  explicit RegionController(WindowContext& context);

  /// Whether something is being found or read.
  bool isBusy() const { return m_work.isRunning(); }

  RegionOffers& offers() { return m_offers; }
  const RegionOffers& offers() const { return m_offers; }

public slots:
  void askForLabels();
  void askForMasks();
  void openLabels(const QString& path) { openLabelFiles({path}); }
  /// Several are masks, each of a structure.
  void openLabelFiles(const QStringList& chosen);
  void setBodyOnly(bool isOn);
  /// What is kept shall be this: of other labels that pieces hang on, those are found anew.
  void setKeep(const limn::Region& region, const limn::Gesture& gesture);
  /// The list of cuts shall be this.
  void setCuts(const std::vector<limn::Cut>& cuts, const QString& gesture);
  /// The same as a part of a gesture that goes on.
  void setCutsOf(const std::vector<limn::Cut>& cuts, const limn::Gesture& gesture);
  /// One cut more, behind those there are or that are being made.
  void addCut(const limn::Cut& cut, const QString& gesture);
  /// Takes back what labels, cuts or Body only hide; a crop stays, and cuts stay in their list.
  void showEverything();
  void cancel();
  void showScene(const limn::Scene& scene);

signals:
  /// A folder that holds no masks, or the one file in it, shall be opened as a volume.
  void volumeMeant(const QString& path);
  /// The label at this place, a piece that was picked, has been given a curve of its own.
  void curveGiven(std::size_t label);
  /// What the voxels of each label say of the volume; none as long as it is not known, or without labels.
  void labelsMeasured(const std::vector<limn::LabelFigures>& figures,
                      const std::shared_ptr<const limn::Volume>& volume);

private:
  /// `kept` is what is kept of the volume as it is done.
  using Work = std::function<FoundRegion(const Region& kept, const Volume& volume, const Progress& progress)>;

  void start(const QString& what, const Gesture& gesture, const Work& work);
  void work(const Gesture& gesture, const Work& work);
  void cut(const Region& region, const std::vector<Cut>& cuts, const Gesture& gesture);
  void keep(const FoundRegion& found, const Gesture& gesture);
  void openInOrder(const std::vector<std::filesystem::path>& files, const Gesture& gesture);
  /// Has masks that others cover read anew, the smallest last; no button where that changes nothing.
  MessageBar::Action smallestOnTop(const FoundRegion& found);
  void sayWhatGaveWay(const Region& before, const FoundRegion& found);
  /// Warns of something about what is kept now.
  void say(const QString& sentence, const QStringList& details = {}, const MessageBar::Action& action = {},
           const MessageBar::Action& other = {});
  void leaveWhatWasSaid(const Scene& scene);
  void measureLabels(const Scene& scene);
  void hideTableBesideLabels(bool isHidden, const Gesture& gesture);
  void end();

  WindowContext& m_context;
  RegionOffers m_offers;
  QAction* m_bodyOnly;
  std::shared_ptr<const Volume> m_volume; ///< the one that is open
  Region m_body;                          ///< of it, where it is known
  QString m_opening; ///< labels or a folder of masks that are being read; empty: none are
  QString m_said;    ///< the sentence about what was kept last, where it may still be said
  /// What that is about.
  struct KeptThen {
    std::shared_ptr<const Volume> volume;
    Region::Kind kind = Region::Kind::all;
    std::vector<std::string> sources; ///< of labels
  };
  KeptThen m_saidOf;
  QString m_doing; ///< what is worked at, in words
  QElapsedTimer m_doingFor;
  std::optional<std::vector<Cut>> m_cutsWanted; ///< while they are being made
  bool m_goesOn = false;                        ///< as a part of a gesture, of which none need take anything
  BackgroundWork m_work;
  std::shared_ptr<const LabelMap> m_labels; ///< that are measured, of the volume
  BackgroundWork m_measuring;
};

/// Whether what is dropped beside an open volume becomes its labels: a file that is named so (LabelNames.h),
/// or a folder of masks.
bool opensAsLabels(const QString& path);

} // namespace limn
