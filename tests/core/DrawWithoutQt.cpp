// SPDX-License-Identifier: GPL-3.0-or-later
// Loads a scene from anything that names one and draws its picture on the processor, without Qt: what a
// binding, a service or a program of somebody else's needs of Limn.
#include "app/core/drawing/PictureMaker.h"
#include "app/core/sources/SceneSource.h"
#include "io/ImageFile.h"
#include "scene/basics/Error.h"

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s SOURCE PICTURE\n", argv[0]);
    return 2;
  }
  try {
    const limn::LoadedScene loaded = limn::loadScene(argv[1], {}, {});
    const limn::ImageSettings& image = loaded.scene.image;
    const std::vector<limn::MadePicture> pictures =
        limn::makePictures({loaded.scene}, {image.width, image.height}, limn::Engine::cpu, 0);
    for (const limn::Message& note : pictures.front().notes)
      std::fprintf(stderr, "%s\n", note.english().c_str());
    limn::writeImage(argv[2], pictures.front().image, image.background, "");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
