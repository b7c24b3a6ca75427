// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <QString>

namespace limn {

/// Whether a file or folder name may tell whom it shows: it holds a part of the patient's name, the patient's
/// number, a date or a DICOM UID. Errs on the side of yes.
bool mayNameThePatient(const QString& name, const PatientLabel& patient);

/// The same for any part of a path.
bool pathMayNameThePatient(const QString& path, const PatientLabel& patient);

/// What a volume is, such as "CT 512×512×120".
QString plainDescription(const Volume& volume);

/// The same as a file name: "ct-512x512x120".
QString plainFileName(const Volume& volume);

/// The name of a volume's file or folder where it names nobody, otherwise its plain file name.
QString shareableName(const QString& path, const Volume& volume);

} // namespace limn
