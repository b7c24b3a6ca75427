// SPDX-License-Identifier: GPL-3.0-or-later
// A program fetches no more texels than its effects need: counted in the assembled text, through every
// function that is called.
#include "glsl/programs/ShaderVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace limn {
namespace {

// The text as a compiler sees it: without comments and without what conditions leave out.
std::string preprocessed(const std::string& text) {
  std::set<std::string> defined;
  std::vector<bool> active{true};
  std::string result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    line = line.substr(0, line.find("//"));
    std::istringstream words(line);
    std::string directive;
    std::string name;
    words >> directive >> name;
    if (directive == "#if" && active.back() && line.find_first_of("!&") != std::string::npos)
      ADD_FAILURE() << "this test reads defined(…) || defined(…) alone, not " << line;
    if (directive == "#if")
      active.push_back(active.back() && std::ranges::any_of(defined, [&line](const std::string& one) {
                         return line.find("defined(" + one + ")") != std::string::npos;
                       }));
    else if (directive == "#ifdef")
      active.push_back(active.back() && defined.contains(name));
    else if (directive == "#ifndef")
      active.push_back(active.back() && !defined.contains(name));
    else if (directive == "#else")
      active.back() = !active.back() && active[active.size() - 2];
    else if (directive == "#endif")
      active.pop_back();
    else if (directive == "#define" && active.back())
      defined.insert(name);
    else if (active.back())
      result += line + "\n";
  }
  EXPECT_EQ(active.size(), 1u);
  return result;
}

// The bodies of the functions by name.
std::map<std::string, std::string> functionsOf(const std::string& text) {
  static const std::regex head(R"((?:^|\n)\w+ (\w+)\([^;{]*\) \{)");
  std::map<std::string, std::string> functions;
  for (std::sregex_iterator match(text.begin(), text.end(), head), end; match != end; ++match) {
    const auto begin = static_cast<std::size_t>(match->position() + match->length());
    std::size_t at = begin;
    for (int depth = 1; depth > 0 && at < text.size(); ++at)
      depth += text[at] == '{' ? 1 : text[at] == '}' ? -1 : 0;
    functions[(*match)[1]] = text.substr(begin, at - begin);
  }
  return functions;
}

int occurrences(const std::string& text, const std::string& word) {
  int count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}

// The fetches of the volume's texture that one call of a function makes, loops counted once.
int volumeFetches(const std::map<std::string, std::string>& functions, const std::string& name) {
  const std::string& body = functions.at(name);
  int count = occurrences(body, "filtered(u_volume");
  for (const auto& [callee, unused] : functions)
    if (callee != name)
      if (const int calls =
              occurrences(" " + body, " " + callee + "(") + occurrences(body, "(" + callee + "("))
        count += calls * volumeFetches(functions, callee);
  return count;
}

std::map<std::string, std::string> functionsFor(EffectSet effects) {
  return functionsOf(preprocessed(fragmentSource(canonical(effects)).text));
}

const EffectSet lit{Effect::lighting, Effect::diffuse, Effect::specular};

TEST(Minimality, anUnlitSampleFetchesTheVolumeOnce) {
  for (const EffectSet& effects :
       {EffectSet{}, EffectSet{Effect::lighting}, EffectSet{Effect::fogExp}, EffectSet{Effect::opacityFactor},
        EffectSet{Effect::earlyTermination, Effect::emptySpaceSkipping}}) {
    const auto functions = functionsFor(effects);
    EXPECT_EQ(volumeFetches(functions, "scalarAt"), 1);
    EXPECT_EQ(volumeFetches(functions, "addMaterial"), 0) << "shading fetches the volume again";
    EXPECT_FALSE(functions.contains("gradientAt"));
    // One in a run of visible samples, one in the search for the next run, which stands before the first run
    // and behind each: one a sample.
    EXPECT_EQ(volumeFetches(functions, "findVisible"), 1);
    EXPECT_EQ(volumeFetches(functions, "gather"), 3);
  }
}

TEST(Minimality, aSampleWithAGradientFetchesSixMoreAndOnlyIfVisible) {
  for (const EffectSet& effects :
       {lit, EffectSet{Effect::lighting, Effect::diffuse}, EffectSet{Effect::opacityMap},
        EffectSet{Effect::gradientOpacity}, lit.with({Effect::exponentMap, Effect::opacityMap}),
        lit.with({Effect::gradientOpacity, Effect::knee, Effect::cutFaces, Effect::significance})}) {
    const auto functions = functionsFor(effects);
    EXPECT_EQ(volumeFetches(functions, "gradientAt"), 6);
    EXPECT_EQ(volumeFetches(functions, "addMaterial"), 6);
    EXPECT_EQ(volumeFetches(functions, "mayBeSeen"), 0);
  }
}

TEST(Minimality, smoothNormalsFetchTheSmoothedVolumeInsteadAndNobodyElseDoes) {
  const auto smooth = functionsFor(lit.with(Effect::smoothNormals));
  EXPECT_EQ(volumeFetches(smooth, "gradientAt"), 0);
  EXPECT_EQ(occurrences(smooth.at("smoothedAt"), "filtered(u_smoothedVolume"), 1);
  EXPECT_EQ(occurrences(smooth.at("gradientAt"), "smoothedAt("), 6);
  EXPECT_FALSE(functionsFor(lit).contains("smoothedAt"));
}

TEST(Minimality, aPreintegratedStepFetchesOneScalarMoreInAll) {
  // The value at a step's end is that at the next one's start; a search, before the first run of visible
  // steps and behind each, looks again where it lands.
  const auto functions = functionsFor({Effect::preintegration});
  EXPECT_EQ(volumeFetches(functions, "findVisible"), 2);
  EXPECT_EQ(volumeFetches(functions, "gather"), 5);
  EXPECT_EQ(volumeFetches(functions, "addMaterial"), 0);
}

// Around the sample six places are looked at in a loop towards the light, and four one by one along the
// normal; of what moves none.
TEST(Minimality, aShadowThatNodesAloneTellFetchesTheVolumeNoMoreThanNone) {
  for (const EffectSet& changes : {EffectSet{}, EffectSet{Effect::opacityMap}}) {
    const EffectSet shadowed =
        canonical(lit.with({Effect::fixedLight, Effect::shadow, Effect::occlusion}).with(changes));
    const auto nearby = functionsOf(preprocessed(fragmentSource(shadowed).text));
    EXPECT_EQ(volumeFetches(nearby, "addMaterial"), 6 + 5 * (changes.isEmpty() ? 1 : 7));
    const auto nodes = functionsOf(preprocessed(fragmentSource(shadowed, {}, LightFrom::nodesAlone).text));
    EXPECT_EQ(volumeFetches(nodes, "addMaterial"), 6);
    EXPECT_FALSE(nodes.contains("extinctionAt"));
  }
}

TEST(Minimality, projectionsOfOneScalarHaveNoShadingAtAll) {
  for (const Effect projection : {Effect::mip, Effect::minip, Effect::average}) {
    const auto functions = functionsFor(lit.with({projection, Effect::fogExp, Effect::cutFaces}));
    for (const char* name : {"addMaterial", "gradientAt", "lit", "fogged", "normalNearCut", "emptySamples"})
      EXPECT_FALSE(functions.contains(name)) << name;
    EXPECT_LE(volumeFetches(functions, "main"), 2);
  }
  const auto functions = functionsFor(lit.with({Effect::xray, Effect::fogExp}));
  EXPECT_EQ(volumeFetches(functions, "addMaterial"), 0);
  EXPECT_FALSE(functions.contains("lit"));
}

TEST(Minimality, aSurfaceIsLitOnceARay) {
  const auto functions = functionsFor(lit.with(Effect::isosurface));
  EXPECT_EQ(volumeFetches(functions, "surfaceColor"), 6);
  EXPECT_FALSE(functions.contains("gather"));
  // At the entry, at a sample, and at the middle of the bracket.
  EXPECT_EQ(volumeFetches(functions, "firstHit"), 3);
}

} // namespace
} // namespace limn
