// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/bench/ScaleBench.h"

#include "app/core/drawing/ProcessCost.h"
#include "cpu/bricks/BrickRenderer.h"
#include "io/AtomicFile.h"
#include "io/VolumeReader.h"
#include "scene/basics/Error.h"
#include "scene/view/Camera.h"
#include "scene/volume/Phantom.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>

namespace limn {
namespace {

constexpr glm::ivec2 pictureSize{512, 512};
constexpr int smallestEdge = 128;
constexpr int mostRanks = 8;

// Greys per HU, and that of -1000 HU, so that 8 bits hold air to enamel and the noise.
constexpr double greysPerHu = 0.08;
constexpr double greyOfAir = 4.0;

double greyOf(double hu) {
  return std::clamp(greyOfAir + greysPerHu * (hu + 1000.0), 0.0, 250.0);
}

// Between which two neighbours a place along one axis lies, and how far it is from the first.
struct Between {
  int first = 0;
  int second = 0;
  float weight = 0.0f;
};

std::vector<Between> betweenAlong(int edge, int samples) {
  std::vector<Between> places;
  for (int i = 0; i < edge; ++i) {
    const double at = std::clamp((i + 0.5) * samples / edge - 0.5, 0.0, samples - 1.0);
    const int first = static_cast<int>(at);
    places.push_back({first, std::min(first + 1, samples - 1), static_cast<float>(at - first)});
  }
  return places;
}

// A few greys of noise, the same on every machine.
unsigned noiseAt(std::size_t voxel) {
  std::uint64_t bits = voxel * 0x9E3779B97F4A7C15ull;
  bits ^= bits >> 29;
  return static_cast<unsigned>((bits * 0xBF58476D1CE4E5B9ull) >> 62);
}

// The phantom, coarsely sampled, at any number of places.
class FinerPhantom {
public:
  explicit FinerPhantom(int edge)
      : m_edge(edge), m_coarse(phantomVolume({.spacingMm = 2.0})), m_dims(m_coarse->grid().dims),
        m_x(betweenAlong(edge, m_dims.x)), m_y(betweenAlong(edge, m_dims.y)),
        m_z(betweenAlong(edge, m_dims.z)) {
    visitVoxels(*m_coarse, [&](const auto& stored) {
      for (const auto hu : stored)
        m_greys.push_back(static_cast<float>(greyOf(hu)));
    });
  }

  glm::dvec3 spacingMm() const {
    return m_coarse->grid().spacingMm * glm::dvec3(m_dims) / static_cast<double>(m_edge);
  }

  void slice(int k, std::vector<std::uint8_t>& voxels) const {
    std::vector<float> row(static_cast<std::size_t>(m_dims.x));
    for (int j = 0; j < m_edge; ++j) {
      mix(m_y[static_cast<std::size_t>(j)], m_z[static_cast<std::size_t>(k)], row);
      for (int i = 0; i < m_edge; ++i) {
        const Between& x = m_x[static_cast<std::size_t>(i)];
        const float grey = std::lerp(row[static_cast<std::size_t>(x.first)],
                                     row[static_cast<std::size_t>(x.second)], x.weight);
        const std::size_t at = static_cast<std::size_t>(j) * m_edge + i;
        voxels[at] = static_cast<std::uint8_t>(static_cast<unsigned>(grey) +
                                               noiseAt(static_cast<std::size_t>(k) * m_edge * m_edge + at));
      }
    }
  }

private:
  void mix(const Between& y, const Between& z, std::vector<float>& row) const {
    const float* rows[] = {at(y.first, z.first), at(y.second, z.first), at(y.first, z.second),
                           at(y.second, z.second)};
    for (std::size_t x = 0; x < row.size(); ++x)
      row[x] = std::lerp(std::lerp(rows[0][x], rows[1][x], y.weight),
                         std::lerp(rows[2][x], rows[3][x], y.weight), z.weight);
  }

  const float* at(int y, int z) const { return &m_greys[voxelOffset(m_dims, 0, y, z)]; }

  int m_edge;
  std::shared_ptr<const Volume> m_coarse;
  glm::ivec3 m_dims;
  std::vector<float> m_greys;
  std::vector<Between> m_x, m_y, m_z;
};

// Skin one can see through, soft tissue and bone.
Scene sceneOf(std::shared_ptr<const Volume> volume) {
  Scene scene;
  scene.camera = defaultCamera(volume->grid());
  scene.volume = std::move(volume);
  scene.transferFunction = {1.0,
                            {{greyOf(-400.0), {0.90, 0.70, 0.55}, 0.0},
                             {greyOf(-150.0), {0.90, 0.70, 0.55}, 0.04},
                             {greyOf(60.0), {0.75, 0.25, 0.20}, 0.1},
                             {greyOf(500.0), {1.00, 0.95, 0.85}, 0.8}}};
  scene.shading.model = ShadingModel::classic;
  scene.quality.stepVoxels = 1.0;
  scene.image.width = pictureSize.x;
  scene.image.height = pictureSize.y;
  return scene;
}

// Partial results are sent as premultiplied RGBA in floats.
constexpr double bytesPerPixel = 16.0;

BrickRow rowOf(int edge, const Scene& scene, int count, int threads) {
  const glm::ivec2 size(scene.image.width, scene.image.height);
  const Bricks bricks(scene.volume->grid(), scene.crop, count);
  BrickRow row;
  row.edge = edge;
  row.bricks = count;
  row.size = size;
  row.reducedMb = (count - 1) * bytesPerPixel * size.x * size.y / 1e6;
  for (int brick = 0; brick < count; ++brick) {
    BrickRenderer renderer(threads);
    renderer.begin(scene, size, bricks.box(brick));
    const FrameCost cost = costOf([&] { renderer.share({{0, 0}, size}); });
    const auto samples = static_cast<double>(renderer.samples());
    row.samples += samples;
    row.mostSamples = std::max(row.mostSamples, samples);
    row.cpuMs += cost.cpuMs;
    row.mostCpuMs = std::max(row.mostCpuMs, cost.cpuMs);
    row.mostKeptMb = std::max(row.mostKeptMb, renderer.memoryMb());
  }
  return row;
}

// Draws a picture of the scene, a volume of `edge` voxels along each axis, in 1, 2, 4 … `most` bricks, one
// brick after the other on `threads` (0: all), and counts what each does; `advance` is called after every
// division.
std::vector<BrickRow> brickRows(int edge, const Scene& scene, int most, int threads,
                                const std::function<void()>& advance) {
  std::vector<BrickRow> rows;
  for (int count = 1; count <= most; count *= 2) {
    rows.push_back(rowOf(edge, scene, count, threads));
    advance();
  }
  return rows;
}

} // namespace

void writeScaleVolume(const std::filesystem::path& path, int edge) {
  const FinerPhantom phantom(edge);
  const glm::dvec3 spacing = phantom.spacingMm();
  std::ofstream file(path, std::ios::binary);
  file << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: " << edge << ' ' << edge << ' ' << edge
       << "\nspacings: " << spacing.x << ' ' << spacing.y << ' ' << spacing.z << "\nencoding: raw\n\n";
  // Some slices at a time, so that the volume is nowhere in memory before it is opened.
  constexpr int slicesAtATime = 16;
  std::vector<std::vector<std::uint8_t>> slices(
      slicesAtATime, std::vector<std::uint8_t>(static_cast<std::size_t>(edge) * edge));
  for (int first = 0; first < edge; first += slicesAtATime) {
    forEachPiece(slicesAtATime, {},
                 [&](int n) { phantom.slice(first + n, slices[static_cast<std::size_t>(n)]); });
    for (const std::vector<std::uint8_t>& slice : slices)
      file.write(reinterpret_cast<const char*>(slice.data()), static_cast<std::streamsize>(slice.size()));
  }
  file.close();
  if (!file)
    throw Error(Error::Kind::other, "The volume of " + std::to_string(edge) +
                                        "³ voxels cannot be written to " + path.string() +
                                        "; make room there, name another folder in TMPDIR, "
                                        "or measure smaller ones with --largest.");
}

std::vector<int> scaleEdges(int largest) {
  std::vector<int> edges;
  for (int edge = smallestEdge; edge <= largest; edge *= 2)
    edges.push_back(edge);
  return edges;
}

int scaleSteps(const BenchEntries& entries, int frames) {
  return 2 + picturesPerRow(frames) * static_cast<int>(entries.engines.size()) +
         std::bit_width(static_cast<unsigned>(mostRanks));
}

ScaleFigures scaleFigures(int edge, const BenchEntries& entries, int frames,
                          const std::function<void()>& advance) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder.path() / "volume.nrrd";
  writeScaleVolume(path, edge);
  advance();
  ScaleRow row;
  row.edge = edge;
  row.voxelsMb = std::pow(edge, 3) / 1e6;
  forgetPeak();
  const double residentBefore = residentMb();
  std::shared_ptr<const Volume> volume;
  row.opened = costOf([&] { volume = readVolume(path); });
  row.openedMb = peakResidentMb() - residentBefore;
  advance();
  ScaleFigures figures;
  const std::string name = std::to_string(edge) + "³";
  const Scene scene = sceneOf(volume);
  for (const BenchRow& drawn :
       benchRows(name, scene, contendersFor(entries, path.string()), frames, advance)) {
    figures.rows.push_back(row);
    figures.rows.back().drawn = drawn;
  }
  figures.bricks = brickRows(edge, scene, mostRanks, entries.threads, advance);
  return figures;
}

} // namespace limn
