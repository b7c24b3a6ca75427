// SPDX-License-Identifier: GPL-3.0-or-later
// The reference against closed forms, within the tolerances and at the orders that the file of cases states.
#include "reference/ReferenceIntegrator.h"
#include "support/AnalyticCases.h"
#include "support/AnalyticScenes.h"
#include "support/CaseLedger.h"
#include "support/Orders.h"

namespace limn {
namespace {

using test::CaseLedger;

void compareRay(const test::AnalyticRay& ray, CaseLedger& ledger) {
  const glm::dvec4 pixel = renderReference(ray.scene, ray.size, 1).pixels[ray.pixel];
  if (ray.alpha)
    ledger.expectNear(ray.id, ray.what + " alpha", pixel.a, *ray.alpha, ray.tolerance);
  for (int channel = 0; ray.color && channel < 3; ++channel)
    ledger.expectNear(ray.id, ray.what + " channel " + std::to_string(channel), pixel[channel],
                      (*ray.color)[channel], ray.tolerance);
}

// Points that cover the unit cube in four dimensions evenly: multiples of powers of the root of x⁵ = x + 1.
glm::dvec4 evenPoint(int i) {
  constexpr double root = 1.1673039782614187;
  const double squared = root * root;
  return glm::fract((i + 0.5) / glm::dvec4(root, squared, squared * root, squared * squared));
}

// The mean error over shifts of the lattice and over an octave of voxel sizes: that of a single lattice is a
// matter of where its voxels fall.
double meanError(const test::RefinedRay& ray, double voxelMm) {
  double sum = 0.0;
  for (int i = 0; i < ray.lattices; ++i) {
    const glm::dvec4 point = evenPoint(i);
    const Scene scene = ray.scene(voxelMm * std::exp2(point.w - 0.5), glm::dvec3(point));
    sum += std::abs(renderReference(scene, {1, 1}, 1).pixels[0][ray.channel] - ray.expected);
  }
  return sum / ray.lattices;
}

// Below it a mean error is that of double precision, and shows no order.
constexpr double rounding = 1e-15;

void compareRefined(const test::RefinedRay& ray, CaseLedger& ledger) {
  std::vector<double> errors;
  for (int i = 0; i <= test::RefinedRay::halvings; ++i)
    errors.push_back(meanError(ray, ray.coarsestMm / std::exp2(i)));
  std::cout << ray.id << ", " << ray.what << ": mean errors";
  for (const double error : errors)
    std::cout << " " << error;
  std::cout << ", orders";
  for (const double order : test::observedOrders(errors, rounding)) {
    std::cout << " " << order;
    ledger.expectWithin(ray.id, ray.what, order, ray.lowestOrder, ray.highestOrder);
  }
  std::cout << "\n";
  if (ray.finestError)
    ledger.expectNear(ray.id, ray.what, errors.back(), *ray.finestError, 0.05 * *ray.finestError);
  if (ray.finestLimit)
    ledger.expectNear(ray.id, ray.what, errors.back(), 0.0, *ray.finestLimit);
  if (errors.front() < rounding)
    for (const double error : errors)
      ledger.expectNear(ray.id, ray.what, error, 0.0, rounding);
}

TEST(ReferenceAnalytic, everyRenderCaseMeetsItsClosedForm) {
  const nlohmann::json cases = test::analyticCases();
  CaseLedger ledger;
  for (const test::AnalyticRay& ray : test::analyticRays(cases))
    compareRay(ray, ledger);
  for (const nlohmann::json& one : cases)
    for (const auto& group : {test::refinedRays, test::refinedSurfaces})
      for (const test::RefinedRay& ray : group(one))
        compareRefined(ray, ledger);
  ledger.expectEvery(cases, [](const nlohmann::json& one) { return test::isOfKind(one, "render"); });
  ledger.print();
}

} // namespace
} // namespace limn
