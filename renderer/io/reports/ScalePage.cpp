// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reports/ScalePage.h"

#include "accuracy/sweep/FigureText.h"
#include "accuracy/times/CostModel.h"
#include "io/reports/HtmlPage.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double largeVolume = 1e12;
constexpr glm::ivec2 largePicture{2048, 2048};
constexpr double manyNodes = 1000;

std::string paragraph(const std::string& text) {
  return "<p>" + escapedHtml(text) + "</p>\n";
}

double cpuMsOf(const ScaleRow& row) {
  return timingOf(processorTimes(row.drawn.views)).median;
}

// What grows, by name.
struct Cost {
  const char* name;
  double (*of)(const ScaleRow& row);
};

constexpr Cost costs[] = {
    {"opening, processor ms", [](const ScaleRow& row) { return row.opened.cpuMs; }},
    {"opening, MB at most", [](const ScaleRow& row) { return row.openedMb; }},
    {"first picture, processor ms", [](const ScaleRow& row) { return row.drawn.firstCpuMs; }},
    {"a picture, processor ms", cpuMsOf},
    {"drawing, MB at most", [](const ScaleRow& row) { return row.drawn.peakMb; }},
};

std::vector<std::string> programsOf(const std::vector<ScaleRow>& rows) {
  std::vector<std::string> programs;
  for (const ScaleRow& row : rows)
    if (std::ranges::find(programs, row.drawn.program) == programs.end())
      programs.push_back(row.drawn.program);
  return programs;
}

std::string sizesTable(const std::vector<ScaleRow>& rows) {
  std::vector<std::string> head{"voxels along an edge"};
  for (const Cost& cost : costs)
    head.emplace_back(cost.name);
  std::string table = "<table>\n" + htmlRow(head, {}, "th");
  for (const std::string& program : programsOf(rows)) {
    table += htmlRow({program}, "group");
    for (const ScaleRow& row : rows) {
      if (row.drawn.program != program)
        continue;
      std::vector<std::string> cells{std::to_string(row.edge)};
      for (const Cost& cost : costs)
        cells.push_back(row.drawn.missing.empty() ? threeDigits(cost.of(row)) : "–");
      table += htmlRow(cells);
    }
    std::vector<std::string> growth{"grows as voxels to the power of"};
    for (const Cost& cost : costs) {
      const auto power = growthOf(rows, program, cost.of);
      growth.push_back(power ? threeDigits(*power) : "–");
    }
    table += htmlRow(growth, "best");
  }
  return table + "</table>\n";
}

std::string bricksTable(const std::vector<BrickRow>& rows) {
  std::string table = "<table>\n" + htmlRow({"voxels along an edge", "ranks", "million samples of all",
                                             "busiest over mean", "processor ms of all", "of the slowest",
                                             "kept by a rank beside its voxels, MB", "sent by all, MB"},
                                            {}, "th");
  for (const BrickRow& row : rows)
    table += htmlRow({std::to_string(row.edge), std::to_string(row.bricks), threeDigits(row.samples / 1e6),
                      threeDigits(imbalanceOf(row)), threeDigits(row.cpuMs), threeDigits(row.mostCpuMs),
                      threeDigits(row.mostKeptMb), threeDigits(row.reducedMb)});
  return table + "</table>\n";
}

std::string nodesTable(const CostFacts& facts, const SupposedNodes& supposed) {
  std::string table =
      "<table>\n" + htmlRow({"nodes", "voxels of each, GB", "kept beside, GB", "read once, s", "marching, ms",
                             "moved for a picture, GB", "putting together, ms", "picture, ms"},
                            {}, "th");
  for (const double nodes : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
    const ManyNodes one = onManyNodes(facts, supposed, largeVolume, largePicture, nodes);
    table += htmlRow({threeDigits(nodes), threeDigits(one.voxelGbEach), threeDigits(one.keptGbEach),
                      threeDigits(one.readSeconds), threeDigits(one.marchMs), threeDigits(one.movedGb),
                      threeDigits(one.compositeMs), threeDigits(one.marchMs + one.compositeMs)});
  }
  return table + "</table>\n";
}

std::string arithmetic(const CostFacts& facts, const SupposedNodes& supposed) {
  const double pixels = static_cast<double>(largePicture.x) * largePicture.y;
  const double edge = std::cbrt(largeVolume);
  const ManyNodes many = onManyNodes(facts, supposed, largeVolume, largePicture, manyNodes);
  const auto text = threeDigits;
  std::string list = "<ul>\n";
  const auto add = [&](const std::string& line) { list += "<li>" + escapedHtml(line) + "</li>\n"; };
  add("Voxels of a node: 10¹² / 1000 = 10⁹; in 16 bits " + text(many.voxelGbEach) +
      " GB, mapped: pages of the file, not memory of the process.");
  add("Kept beside them (ranges of blocks, distances): " + text(facts.keptBytesPerVoxel) +
      " bytes a voxel, measured; " + text(many.keptGbEach) + " GB a node.");
  add("Read once from a disk of each node: " + text(many.voxelGbEach) + " GB / " +
      text(supposed.diskBytesPerSecond / 1e9) + " GB/s = " + text(many.readSeconds) + " s.");
  add("Samples: " + text(facts.samplesPerPixelEdge) + " (measured, of pixels times voxels along an edge) · " +
      text(pixels) + " pixels · " + text(edge) + " = " +
      text(facts.samplesPerPixelEdge * pixels * edge / 1e9) + "·10⁹.");
  add("Marching: samples / (1000 nodes · " + text(supposed.cores) + " cores · " +
      text(facts.samplesPerCpuSecond / 1e6) + "·10⁶ a second, measured) · " + text(facts.imbalance) +
      " (busiest over mean, measured) = " + text(many.marchMs) + " ms.");
  add("A message: " + text(pixels) + " pixels · 16 bytes = " + text(many.messageMb) +
      " MB; every node but one sends one: " + text(many.movedGb) + " GB.");
  add("Putting together: ⌈log₂ 1000⌉ = 10 messages one after the other at " +
      text(supposed.linkBytesPerSecond / 1e9) + " GB/s = " + text(many.compositeMs) + " ms.");
  return list + "</ul>\n";
}

} // namespace

std::string scalePage(const std::string& command, const std::string& machine,
                      const std::vector<ScaleRow>& rows, const std::vector<BrickRow>& bricks) {
  std::string page = "<h1>How costs grow</h1>\n<p class=\"facts\">" + escapedHtml(machine) + " · " +
                     escapedHtml(command) + "</p>\n";
  page +=
      "<h2>With the voxels</h2>\n" +
      paragraph("Volumes of 8 bits, made for this, opened from a file and drawn in 512 × 512 pixels with "
                "steps of one voxel. Twice the voxels along each edge are eight times as many: a power of "
                "1 is eight times the cost, one of 0.33 twice. Powers are those between the two largest "
                "sizes.") +
      sizesTable(rows);
  if (bricks.empty())
    return htmlPage("How costs grow", page);
  const CostFacts facts = costFacts(bricks);
  const SupposedNodes supposed;
  page += "<h2>With the ranks</h2>\n" +
          paragraph("One picture divided into bricks as limn-mpi does it, one rank each, drawn one after the "
                    "other on this machine: work and bytes are counted, since ranks that share cores would "
                    "tell nothing by their time.") +
          bricksTable(bricks);
  page +=
      "<h2>10¹² voxels on 1000 nodes</h2>\n" +
      paragraph("Measured here: samples a second of one core, samples of a picture, bytes kept, and how "
                "unevenly bricks share the work (for no more bricks than in the table: with more of them "
                "it grows). Supposed: nodes of " +
                threeDigits(supposed.cores) +
                " such cores, 10 GB/s between them, a disk of 1 GB/s each, voxels of 16 bits, a picture of "
                "2048 × 2048 pixels.") +
      arithmetic(facts, supposed) + nodesTable(facts, supposed) +
      paragraph("Where it stops: marching shrinks as 1/nodes, putting together grows as their logarithm. "
                "With " +
                threeDigits(mostUsefulNodes(facts, supposed, largeVolume, largePicture)) +
                " nodes a picture is made soonest; beyond, only memory gains. Messages hold every pixel, "
                "though a brick of 1000 covers a hundredth of them: sending what it covers alone would "
                "move that limit.");
  return htmlPage("How costs grow", page);
}

} // namespace limn
