// SPDX-License-Identifier: GPL-3.0-or-later
#include "FuzzInput.h"

#include "io/looks/dicom/DicomLook.h"

// A presentation state that was read makes a scene on the grid of any volume.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace limn;
  test::harmless([&] {
    const DicomLook look = parseDicomLook(test::textOf(data, size), "input");
    std::vector<Message> changes;
    const Scene scene = sceneOf(look, {{10, 20, 30}, {1.0, 1.0, 2.0}, {0.0, 0.0, 0.0}}, changes).scene;
    for (int axis = 0; axis < 3; ++axis)
      if (!(scene.crop.lower[axis] < scene.crop.upper[axis]))
        test::fault("a crop leaves nothing and is kept");
    if (look.transferFunction.points.size() < 2)
      test::fault("a table became less than two points");
  });
  return 0;
}
