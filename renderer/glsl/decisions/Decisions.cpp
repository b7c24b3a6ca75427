// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/decisions/Decisions.h"

#include "scene/ProjectionFacts.h"

namespace limn {
namespace {

// The groups, in the order of the table.
namespace group {
const char* const tables = "look-up table";
const char* const volumes = "volume texture";
const char* const corrections = "opacity correction";
const char* const places = "sample in its step";
const char* const ends = "early termination";
const char* const gradients = "gradient";
const char* const orders = "classification";
} // namespace group

struct List {
  std::vector<DecisionVariant> variants;

  template <class Value>
  void add(const char* group, const char* name, Value Decisions::*decision, Value value) {
    DecisionVariant variant{group, name, value == Decisions{}.*decision, {}, std::nullopt};
    variant.decisions.*decision = value;
    variants.push_back(variant);
  }

  void addEnd(const char* name, double earlyTermination) {
    const bool isDefault = earlyTermination == Quality{}.earlyTermination;
    variants.push_back({group::ends, name, isDefault, {}, earlyTermination});
  }
};

bool canShow(const DecisionVariant& variant, const Scene& scene, EffectSet effects) {
  if (variant.group == group::corrections || variant.group == group::orders)
    return integrates(scene.projection);
  if (variant.group == group::ends)
    return composites(scene.projection);
  if (variant.group == group::gradients)
    return effects.has(Effect::gradient);
  if (variant.group == group::places)
    return scene.projection != Projection::isosurface;
  return true;
}

} // namespace

std::vector<DecisionVariant> decisionVariants() {
  List list;
  list.add(group::tables, "none: exact between control points", &Decisions::table, TableFormat::exact);
  list.add(group::tables, "floats, 1024 entries", &Decisions::table, TableFormat::floats1024);
  list.add(group::tables, "floats, 256 entries", &Decisions::table, TableFormat::floats256);
  list.add(group::tables, "8 bits, 256 entries", &Decisions::table, TableFormat::bytes256);
  list.add(group::volumes, "32-bit floats (R32F)", &Decisions::volume, VolumeFormat::r32f);
  list.add(group::volumes, "16 bits (R16)", &Decisions::volume, VolumeFormat::r16);
  list.add(group::volumes, "8 bits (R8)", &Decisions::volume, VolumeFormat::r8);
  list.add(group::corrections, "after the function is looked up", &Decisions::table, TableFormat::exact);
  list.add(group::corrections, "in the table (floats, 256 entries)", &Decisions::table,
           TableFormat::correctedFloats);
  list.add(group::places, "in the middle", &Decisions::place, SamplePlace::middle);
  list.add(group::places, "at the front", &Decisions::place, SamplePlace::front);
  list.addEnd("at 0.998", 0.998);
  list.addEnd("at 0.98", 0.98);
  list.addEnd("never", 1.0);
  list.add(group::gradients, "on the fly, central differences", &Decisions::gradients,
           GradientFormat::onTheFly);
  list.add(group::gradients, "stored as 16-bit floats", &Decisions::gradients, GradientFormat::halves);
  list.add(group::gradients, "stored as 8-bit directions and moduli", &Decisions::gradients,
           GradientFormat::directions);
  list.add(group::gradients, "on the fly, forward differences", &Decisions::gradients,
           GradientFormat::forward);
  list.add(group::orders, "after interpolation", &Decisions::classification,
           ClassificationOrder::afterInterpolation);
  list.add(group::orders, "before interpolation, 16-bit floats", &Decisions::classification,
           ClassificationOrder::beforeInHalves);
  list.add(group::orders, "before interpolation, 8 bits", &Decisions::classification,
           ClassificationOrder::beforeInBytes);
  return list.variants;
}

std::vector<DecisionVariant> decisionVariants(const Scene& scene, EffectSet effects) {
  std::vector<DecisionVariant> variants = decisionVariants();
  std::erase_if(variants, [&](const DecisionVariant& variant) { return !canShow(variant, scene, effects); });
  return variants;
}

} // namespace limn
