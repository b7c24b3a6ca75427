// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/asking/FileDialogs.h"
#include "app/window/WindowContext.h"
#include "widgets/controls/BackgroundWork.h"
#include "widgets/controls/TimeLeft.h"

#include <QDialog>
#include <QPointer>

#include <functional>
#include <memory>
#include <vector>

class QLabel;
class QLayout;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace limn {

/// A dialog that makes files of what is open, the same way for every kind: it asks how and then where, works
/// beside the event loop, and says below its fields how far that is and what came of it. While it works, its
/// button to close says "Cancel": whoever closes it then ends the work, and closes it by a second step. A
/// kind registers with `offerExport`.
class ExportDialog : public QDialog {
  Q_OBJECT

public:
  /// Shows it above the others.
  void present();

  /// The window shows another scene.
  void follow(const Scene& scene, bool isSuited);

  bool isWorking() const;
  /// What it says below its fields.
  QString said() const;

signals:
  void workingChanged(bool isWorking);

protected:
  struct Words {
    QString name;      ///< of the dialog in object names: what those of its parts begin with
    QString work;      ///< names the bar of progress for those who cannot see it
    QString cancelled; ///< what is said once work was ended
  };
  ExportDialog(WindowContext& context, const Words& words);

  /// What work comes to: a sentence, and what is to be done with it on the thread of the window.
  struct Outcome {
    QString sentence;
    std::function<void()> deliver = {};
  };
  using Work = std::function<Outcome(const Effort& effort)>;
  using Writing = std::function<Outcome(const std::string& path, const Effort& effort)>;

  /// Works on a thread of its own; ends what it works at.
  void run(const Work& work);
  /// Asks where, and writes there.
  void exportTo(const SaveQuestion& question, const Writing& write);

  /// Adds what is said, the bar and the buttons: one that starts the work, one that starts `other` work.
  void addFoot(QVBoxLayout* column, QPushButton* start, QPushButton* other = nullptr);

  /// A place for fields, which nobody can edit while the dialog works at what they asked for.
  QWidget* outOfUseWhileWorking(QLayout* fields);

  void say(const QString& text);
  /// Whether its fields ask for something that can be made.
  void setStartable(bool isStartable);
  QLabel* text() const { return m_text; }
  /// What is said once work is ended: what is true of that which begins now.
  void setCancelled(const QString& sentence) { m_cancelled = sentence; }

  /// The work that begins next draws so many pictures one after another, each in a time of its own.
  void setPictures(std::size_t count) { m_pictures = count; }
  /// So much of the work that begins next tells how long the rest takes (TimeLeft).
  void setTelling(double share) { m_telling = share; }

  /// Nothing is worked at any more; `sentence` says what came of it.
  void end(const QString& sentence);

  void done(int result) override;

  WindowContext& m_context;
  BackgroundWork m_work;

private:
  /// What is being done at `fraction`.
  virtual QString doing(double fraction) const = 0;
  /// How far is then what comes at one pace, by which the time left is told, 0..1.
  virtual double atOnePace(double fraction) const { return fraction; }
  /// Before it is shown, or raised where `isNew` is false.
  virtual void begin(bool isNew) = 0;
  virtual void showScene(const Scene&) {}
  virtual void sayOutcome(const QString& sentence) { say(sentence); }
  void showProgress(double fraction); ///< 0..1

  bool m_isSuited = true; ///< what is open can be exported
  QString m_cancelled;
  QLabel* m_text;
  QProgressBar* m_bar;
  QPushButton* m_close;
  TimeLeft m_left;
  std::size_t m_pictures = 1;
  double m_telling = aHundredth;
  QPointer<QWidget> m_before; ///< what had the keyboard when work began
  std::vector<QPushButton*> m_starts;
};

/// Registers a kind of export: its action, enabled while `Dialog::suits(scene)` holds, shows the dialog,
/// which is made of the context and `with` when it is first asked for, by that or by what is returned.
template <class Dialog, class... With>
std::function<Dialog&()> offerExport(WindowContext& context, const QString& action, const ActionLook& look,
                                     With... with) {
  QAction* offered = context.actions.add(action, look);
  const auto dialog = std::make_shared<QPointer<Dialog>>();
  const auto made = [&context, dialog, with...]() -> Dialog& {
    if (!*dialog)
      *dialog = new Dialog(context, with...);
    return **dialog;
  };
  QObject::connect(offered, &QAction::triggered, &context.window, [made] { made().present(); });
  context.followers.add(SceneFollowers::Stage::after, [offered, dialog](const Scene& scene) {
    offered->setEnabled(Dialog::suits(scene));
    if (*dialog)
      (*dialog)->follow(scene, Dialog::suits(scene));
  });
  return made;
}

} // namespace limn
