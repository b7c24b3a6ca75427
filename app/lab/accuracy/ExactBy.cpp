// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/accuracy/ExactBy.h"

#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"

#include <sys/wait.h>

#include <cstdlib>

namespace limn {
namespace {

namespace fs = std::filesystem;

// As one word for a shell.
std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char letter : text)
    word += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return word + "'";
}

[[noreturn]] void failDrawing(const DrawingCommand& command, const std::string& what) {
  throw Error(Error::Kind::usage, "--exact-by \"" + command.words + "\" " + what +
                                      "; it takes a program that draws what limn render draws, such as "
                                      "\"mpirun -n 4 limn-mpi\".");
}

// Pictures carry the scene that they show, and where its volume and labels lie, and how many pictures they
// are.
bool showsScene(const fs::path& picture, const Scene& scene, const std::string& volume) {
  return parseScene(readImageDescription(picture), picture.string()).scene ==
         parseScene(sceneToJson(scene, volume), "the scene asked for").scene;
}

Image drawn(const DrawingCommand& command, const Scene& scene) {
  std::optional<ScratchFolder> folder;
  try {
    folder.emplace(fs::absolute(command.folder));
  } catch (const Error&) {
    throw Error(Error::Kind::other, "The exact picture cannot be drawn, because nothing can be written to " +
                                        command.folder.string() + "; choose another folder with -o.");
  }
  const fs::path source = folder->path() / "scene.json";
  const fs::path picture = folder->path() / "picture.exr";
  writeFileAtomically(source, sceneToJson(scene, command.volume));
  const int raw = std::system((command.words + " " + quoted(source.string()) + command.readOptions +
                               " --quiet -o " + quoted(picture.string()))
                                  .c_str());
  if (!WIFEXITED(raw) || WEXITSTATUS(raw) != 0 || !fs::exists(picture))
    failDrawing(command, "drew no picture");
  if (!showsScene(picture, scene, command.volume))
    failDrawing(command, "drew another scene than it was given");
  return readExr(picture);
}

} // namespace

DrawPrecisely exactBy(const DrawingCommand& command) {
  return [command](const Scene& scene, const glm::ivec2& size, const std::vector<std::uint8_t>& wanted,
                   PrecisePixels& pixels) {
    const Image picture = drawn(command, scene);
    if (picture.size != size)
      failDrawing(command, "drew a picture of another size");
    for (std::size_t i = 0; i < pixels.size(); ++i)
      if (wanted[i])
        pixels[i] = glm::dvec4(picture.pixels[i]);
  };
}

} // namespace limn
