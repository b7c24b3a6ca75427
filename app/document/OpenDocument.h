// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/Session.h"
#include "scene/presets/Preset.h"
#include "scene/volume/Histogram.h"

namespace limn {

/// A source as it was asked for, to read it again with other options.
struct Request {
  QString source;
  SourceOptions options;
  bool isUnsavedSession = false; ///< one that Limn kept, not a file of the user's
};

/// What is open beside the scene (Session): where it came from, the file it was saved to, the preset in use,
/// and what counts as saved.
class OpenDocument {
public:
  /// Nothing is open at first.
  explicit OpenDocument(Session& session) : m_session(session) {}

  const Scene& scene() const { return m_session.scene(); }
  const std::string& volumePath() const { return m_session.volumePath(); }

  /// Whether the scene (but for the camera) differs from the one opened or saved last.
  bool isEdited() const { return m_session.isEdited(); }

  /// What was asked for to get what is open, with the options that its volume was read with.
  const Request& request() const { return m_request; }

  /// The session file that it was read from or saved to; empty where there is none.
  const QString& sessionFile() const { return m_sessionFile; }

  /// The session file that it was read from without being all of it; it is not to be saved over. Empty where
  /// there is none.
  const QString& sparedSession() const { return m_sparedSession; }

  /// Whether somebody else has changed that file since it was read or written here. One that has gone has
  /// nothing to lose.
  bool sessionFileWasChanged() const;

  /// Of the volume's values.
  const Histogram& histogram() const { return m_histogram; }

  /// Shows what was loaded in the place of what was open. An unsaved session goes on as what it was before it
  /// was left, and counts as unsaved.
  void open(const LoadedScene& loaded, const Request& request, const Histogram& histogram);
  void close();

  /// The preset that the scene was made from, and whether anything that it sets is another now.
  struct PresetInUse {
    std::string name; ///< empty: none
    bool isModified = false;
    bool operator==(const PresetInUse&) const = default;
  };
  PresetInUse presetInUse() const;

  /// What a session file says of it, but for where its volume is seen from there.
  SessionDocument described() const;

  /// Moves the camera because the window changed its shape: alone no change of what counts as saved.
  void fitCamera(const Camera& camera);

  /// The session `now` counts as saved; it does not after an unsaved one was opened.
  void settle(const SessionDocument& now) { m_settled = now; }
  /// It was saved to a file as `now`, whose text has this digest (digestOf).
  void settleIn(const QString& file, const SessionDocument& now, const std::string& digest = {});

  /// What has to be kept of the session `now` so that nothing is lost, called by the file that saving would
  /// write to where there is one; absent as long as all is as it was when it counted as saved.
  std::optional<SessionDocument> unsaved(SessionDocument now) const;

private:
  Session& m_session;
  Request m_request;
  QString m_sessionFile;
  QString m_sparedSession;
  std::string m_sessionDigest; ///< of that file as it was read or written last; empty: not known
  Histogram m_histogram;
  SessionDocument m_settled;
};

/// All that is open: the scene with its history, and what is known of it. It may go from a window to another
/// that takes its place.
struct OpenWork {
  Session session;
  OpenDocument document{session};
};

} // namespace limn
