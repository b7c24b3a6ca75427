// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/ConvergedPicture.h"

#include <filesystem>
#include <string>

namespace limn {

/// A program that draws what `limn render` draws, in single precision, such as `mpirun -n 4 limn-mpi`.
struct DrawingCommand {
  std::string words;            ///< for a shell; SOURCE and options are put behind them
  std::string volume;           ///< as scenes name it
  std::string readOptions;      ///< how it is to read the volume, as on the command line
  std::filesystem::path folder; ///< every machine that draws sees it
};

/// Draws pictures by that program, for the converged one: whole ones, of which the wanted pixels are taken,
/// in the size that the scene names. Throws Error (usage) where the program fails or draws another scene.
DrawPrecisely exactBy(const DrawingCommand& command);

} // namespace limn
