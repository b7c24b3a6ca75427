// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SessionFile.h"
#include "scene/basics/Image.h"
#include "scene/view/CompareLayout.h"

#include <QObject>

#include <functional>

namespace limn {

/// Two pictures of one size as a layout of two shows them: side by side, parted at `wipe` (0..1 of the
/// width), or as their amplified difference over `background`, which is opaque.
Image comparedPicture(const Image& left, const Image& right, CompareLayout layout, double wipe,
                      const glm::dvec3& background);

struct WindowContext;

/// Writes what is open as session, scene and picture.
class SavingController : public QObject {
  Q_OBJECT

public:
  /// `session` tells the session of the moment.
  SavingController(WindowContext& context, std::function<SessionDocument()> session);

  /// Saves to the session's file, or asks for one where there is none yet.
  void saveSession();
  void saveSessionAs();
  void saveScene();

  /// What the above do once a name is chosen. The picture is the one at rest.
  void writeSession(const QString& path);
  void writeScene(const QString& path);
  void writePicture(const QString& path);

  /// How a picture that may travel calls the volume and the label map: without folders.
  std::string volumeInPicture() const;
  std::string labelsInPicture() const;

signals:
  void sessionSaved();

private:
  std::string seenFrom(const std::filesystem::path& file, const std::filesystem::path& named,
                       const std::string& kind) const;
  std::string volumeSeenFrom(const std::filesystem::path& file) const;
  std::string labelsSeenFrom(const std::filesystem::path& file) const; ///< empty where there are none

  WindowContext& m_context;
  std::function<SessionDocument()> m_session;
};

} // namespace limn
