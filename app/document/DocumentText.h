// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <QDateTime>
#include <QString>

namespace limn {

class OpenDocument;

/// What the window is called that shows it: by its file or folder, and what a series of DICOM says that it
/// is; "[*]" stands where unsaved changes are marked. Names the patient only where that is asked for.
QString titleOf(const OpenDocument& document, bool showsPatient);

/// A moment in the time of here: "27 Nov 2026, 20:13".
QString momentText(const QDateTime& moment);

/// What may stand in a list without naming anybody, of what was opened. A volume is open.
QString labelOf(const OpenDocument& document);

/// The same of a file in which what is open was saved.
QString labelOf(const OpenDocument& document, const QString& file);

/// The same of its volume, whatever names that: a figure or scene that was opened is none of the work on it.
QString labelOfVolume(const OpenDocument& document);

/// What a file that is made of it may be called without naming anybody, without ending.
QString suggestedName(const OpenDocument& document);

/// Size and range: "512×512×120 · 0.5×0.5×1 mm · -1024 to 3071 HU".
QString volumeText(const Volume& volume);

/// What was noteworthy in reading a volume, a sentence each: first that its slices slanted, where they did.
QStringList remarksOn(const Volume& volume, const std::vector<Message>& notes);

} // namespace limn
