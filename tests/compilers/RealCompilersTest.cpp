// SPDX-License-Identifier: GPL-3.0-or-later
// What the compiler of graphics cards makes of every program that a scene can call for: it takes all of them,
// and their numbers fit into registers. Nothing is drawn, and nothing here says how fast.
#include "Spirv.h"
#include "glsl/programs/ShaderVariant.h"
#include "scene/ProjectionFacts.h"
#include "scene/effects/EffectPlan.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/ReachableSets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>

namespace limn {
namespace {

// AMD's four generations of instructions that RADV compiles for, oldest first.
const std::array<const char*, 4> chips{"polaris10", "vega20", "navi21", "gfx1100"};

constexpr std::array models{ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced,
                            ShadingModel::robust};

struct Program {
  EffectSet effects;
  Decisions decisions = {};
  bool isSlice = false;
  bool isOfEveryChip = false; ///< every chip compiles it, not one of them

  ShaderSource vertex() const { return isSlice ? sliceVertexSource() : vertexSource(); }
  ShaderSource fragment() const {
    return isSlice ? sliceSource(effects) : fragmentSource(effects, decisions);
  }
  std::string name() const {
    std::string names = isSlice ? "slices" : "rays";
    for (int i = 0; i < effectCount; ++i)
      if (const auto effect = static_cast<Effect>(i); effects.has(effect))
        names += std::string(" ") + describe(effect).name;
    return names;
  }
};

using Programs = std::vector<Program>;

// What a head calls for in a model and a projection, and nothing beside.
EffectSet calledFor(ShadingModel model, Projection projection) {
  static const std::shared_ptr<const Volume> volume = phantomVolume({.spacingMm = 12.0});
  Scene scene = headScene(volume, model);
  scene.projection = projection;
  return requiredEffects(scene, {}).effects;
}

std::set<EffectSet> everyBase() {
  std::set<EffectSet> bases;
  for (const ShadingModel model : models)
    for (const Projection projection : projections)
      bases.insert(calledFor(model, projection));
  return bases;
}

Programs programsOf(const std::set<EffectSet>& sets) {
  Programs programs;
  for (const EffectSet& effects : sets)
    programs.push_back({effects});
  return programs;
}

Programs ofEveryChip(Programs programs) {
  for (Program& program : programs)
    program.isOfEveryChip = true;
  return programs;
}

// A program as every chip takes it: what each of them compiles is translated once.
test::SpirvProgram translationOf(const Program& program) {
  const ShaderSource fragment = program.fragment();
  if (!program.isOfEveryChip)
    return test::spirvOf(program.vertex(), fragment);
  static std::map<std::string, test::SpirvProgram> translations;
  const auto known = translations.find(fragment.text);
  if (known != translations.end())
    return known->second;
  return translations.emplace(fragment.text, test::spirvOf(program.vertex(), fragment)).first->second;
}

// Each effect by itself, over every model and projection.
Programs eachEffectAlone() {
  std::set<EffectSet> sets = everyBase();
  for (const EffectSet& base : everyBase())
    for (int i = 0; i < effectCount; ++i)
      sets.insert(canonical(base.with(static_cast<Effect>(i))));
  return ofEveryChip(programsOf(sets));
}

// All effects at once that have a neutral value.
Programs allEffectsTogether() {
  std::set<EffectSet> sets;
  for (const EffectSet& base : everyBase())
    sets.insert(withAllNeutral(base));
  return ofEveryChip(programsOf(sets));
}

// Everything else: effects in all combinations, other decisions about accuracy, slices.
Programs everyCombination() {
  Programs programs = programsOf(test::reachableSets());
  for (const ShadingModel model : models)
    for (const DecisionVariant& variant : decisionVariants())
      if (variant.decisions != Decisions{})
        programs.push_back({calledFor(model, Projection::composite), variant.decisions});
  for (const EffectSet& effects : test::sliceSets())
    programs.push_back({effects, {}, true});
  return programs;
}

// A chip's own share: each program is compiled for one chip at least. LIMN_EVERY_CHIP asks for all of them.
Programs shareOf(const std::string& chip, const Programs& all) {
  if (std::getenv("LIMN_EVERY_CHIP") != nullptr)
    return all;
  const auto place = std::find(chips.begin(), chips.end(), chip) - chips.begin();
  Programs share;
  for (auto i = static_cast<std::size_t>(place); i < all.size(); i += chips.size())
    share.push_back(all[i]);
  return share;
}

// The most registers that a program may take: what this compiler took over every program on every chip
// (EVIDENCE). More means that a block holds numbers for longer than it needs them. Another version takes
// others.
const std::string measuredMesa = "22.3.6";
struct Room {
  int samples = 0;       ///< VGPRs; each number is one of a fragment's own
  int preintegrated = 0; ///< holds both ends of a segment and the sums between them
  int localSteps = 0;    ///< holds the piece at hand, the two ways on, and the place in a block
  int spilledSgprs = 0;  ///< of local steps; they go to lanes of a VGPR, not to memory
  int spilledOfOthers = 0;
};
constexpr Room alone{48, 60, 84, 0};
constexpr Room together{64, 76, 88, 78};
// With own weights eight texels, and those of the gradient's samples, are on their way at once.
constexpr Room aloneWeighing{64, 60, 84, 0};
constexpr Room togetherWeighing{64, 84, 128, 78};
// Where looks of labels meet, looks, shares and weights of eight voxels are held while one look after the
// other is gathered; pre-integrated steps within one look hold both their ends besides.
constexpr Room aloneByLabel{84, 0, 84, 0};
constexpr Room togetherByLabel{96, 96, 128, 126};
// Smooth normals read a second volume; the numbers of its place and scale are the same for all rays.
constexpr Room togetherSmooth{64, 76, 88, 122};
// Light on its way classifies two more places for each sample; a tolerance is not for shaders there.
constexpr Room togetherTravelling{80, 76, 0, 0, 35};
constexpr Room togetherTravellingWeighing{128, 84, 0, 0, 0};
constexpr Room togetherTravellingByLabel{96, 0, 0, 0, 24};
constexpr Room togetherTravellingByLabelPreintegrated{0, 96, 0, 0, 46};

Room togetherOf(EffectSet effects) {
  const bool travels = effects.hasAny(travellingLight);
  if (effects.has(Effect::labelLooks) && travels)
    return effects.has(Effect::preintegration) ? togetherTravellingByLabelPreintegrated
                                               : togetherTravellingByLabel;
  if (effects.has(Effect::labelLooks))
    return togetherByLabel;
  if (effects.has(Effect::ownWeights))
    return travels ? togetherTravellingWeighing : togetherWeighing;
  return travels ? togetherTravelling : effects.has(Effect::smoothNormals) ? togetherSmooth : together;
}

Room aloneOf(EffectSet effects) {
  return effects.has(Effect::labelLooks)   ? aloneByLabel
         : effects.has(Effect::ownWeights) ? aloneWeighing
                                           : alone;
}

using RoomOf = Room (*)(EffectSet effects);

int mostVgprs(const Room& room, EffectSet effects) {
  if (effects.has(Effect::localSteps))
    return room.localSteps;
  return effects.has(Effect::preintegration) ? room.preintegrated : room.samples;
}

int mostSpilledSgprs(const Room& room, EffectSet effects) {
  return effects.has(Effect::localSteps) ? room.spilledSgprs : room.spilledOfOthers;
}

// The largest figures of many programs.
struct Most {
  int programs = 0;
  test::StageFigures of;

  void add(const test::StageFigures& one) {
    ++programs;
    of.instructions = std::max(of.instructions, one.instructions);
    of.vgprs = std::max(of.vgprs, one.vgprs);
    of.sgprs = std::max(of.sgprs, one.sgprs);
    of.spilledSgprs = std::max(of.spilledSgprs, one.spilledSgprs);
  }
};

std::string nameOfChip(const ::testing::TestParamInfo<const char*>& chip) {
  return chip.param;
}

class RealCompilers : public ::testing::TestWithParam<const char*> {
protected:
  void SetUp() override {
    try {
      m_compiler.emplace(GetParam());
    } catch (const test::NoCompiler& missing) {
      GTEST_SKIP() << missing.what();
    }
  }

  int subTexelBits() const { return m_compiler->subTexelBits(); }

  std::optional<test::StageFigures> fragmentOf(const Program& program) const {
    try {
      const test::SpirvProgram spirv = translationOf(program);
      const test::ProgramFigures figures = m_compiler->compile(spirv.vertex, spirv.fragment);
      EXPECT_GT(figures.vertex.instructions, 0);
      EXPECT_TRUE(figures.vertex.spillsNothing());
      return figures.fragment;
    } catch (const std::runtime_error& refused) {
      ADD_FAILURE() << program.name() << ": " << refused.what();
      return std::nullopt;
    }
  }

  void expectRoom(RoomOf roomOf, const Programs& programs) const {
    std::map<std::string, Most> most;
    for (const Program& program : programs)
      if (const std::optional<test::StageFigures> figures = fragmentOf(program)) {
        EXPECT_GT(figures->instructions, 0) << program.name();
        EXPECT_EQ(figures->spilledVgprs, 0) << program.name();
        EXPECT_EQ(figures->scratchBytes, 0) << program.name();
        most[kindOf(program.effects)].add(*figures);
        if (m_compiler->mesaVersion() != measuredMesa)
          continue;
        const Room room = roomOf(program.effects);
        EXPECT_LE(figures->spilledSgprs, mostSpilledSgprs(room, program.effects)) << program.name();
        EXPECT_LE(figures->vgprs, mostVgprs(room, program.effects)) << program.name();
      }
    for (const auto& [kind, figures] : most)
      std::cout << m_compiler->deviceName() << ", " << figures.programs << " programs " << kind
                << ": at most " << figures.of.instructions << " instructions, " << figures.of.vgprs
                << " VGPRs, " << figures.of.sgprs << " SGPRs, " << figures.of.spilledSgprs
                << " of them spilled\n";
  }

private:
  static std::string kindOf(EffectSet effects) {
    const std::string weights = effects.has(Effect::labelLooks)   ? ", looks of labels"
                                : effects.has(Effect::ownWeights) ? ", own weights"
                                                                  : "";
    if (effects.has(Effect::localSteps))
      return "of error-controlled steps" + weights;
    return (effects.has(Effect::preintegration) ? "of pre-integrated steps" : "of samples") + weights;
  }

  std::optional<test::NullCompiler> m_compiler;
};

TEST_P(RealCompilers, everyEffectAloneCompilesAndSpillsNothing) {
  expectRoom(aloneOf, eachEffectAlone());
}

TEST_P(RealCompilers, everyProgramCompilesAndSpillsNothingToMemory) {
  expectRoom(togetherOf, allEffectsTogether());
  expectRoom(togetherOf, shareOf(GetParam(), everyCombination()));
}

TEST_P(RealCompilers, samplersWeighTexelsInEightBits) {
  // What makes a card's picture differ from those of the software drivers (FilterBits).
  EXPECT_EQ(subTexelBits(), 8);
}

INSTANTIATE_TEST_SUITE_P(Chips, RealCompilers, ::testing::ValuesIn(chips), nameOfChip);

void printRow(const std::string& name, const std::array<int, models.size()>& row) {
  std::cout << "| " << name;
  for (const int number : row)
    std::cout << " | " << number;
  std::cout << " |\n";
}

class InstructionsByEffect : public RealCompilers {
protected:
  int instructionsOf(EffectSet effects) const {
    const std::optional<test::StageFigures> figures = fragmentOf({effects});
    return figures ? figures->instructions : 0;
  }
};

TEST_P(InstructionsByEffect, aPictureThatCallsForLessTakesFewer) {
  std::array<EffectSet, models.size()> bases;
  std::array<int, models.size()> instructions{}, all{};
  for (std::size_t m = 0; m < models.size(); ++m) {
    bases[m] = calledFor(models[m], Projection::composite);
    instructions[m] = instructionsOf(bases[m]);
    all[m] = instructionsOf(withAllNeutral(bases[m]));
    EXPECT_LT(instructions[m], all[m]);
  }
  EXPECT_TRUE(std::is_sorted(instructions.begin(), instructions.end()));
  std::cout << "| " << GetParam() << " | unlit | classic | enhanced | robust |\n|---|---|---|---|---|\n";
  printRow("nothing else", instructions);
  for (int i = 0; i < effectCount; ++i) {
    const auto effect = static_cast<Effect>(i);
    std::array<int, models.size()> with{};
    for (std::size_t m = 0; m < models.size(); ++m)
      with[m] = instructionsOf(canonical(bases[m].with(effect)));
    if (with != instructions)
      printRow(describe(effect).name, with);
  }
  printRow("all", all);
}

INSTANTIATE_TEST_SUITE_P(Chip, InstructionsByEffect, ::testing::Values("navi21"), nameOfChip);

} // namespace
} // namespace limn
