// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/WidgetSamples.h"

#include "widgets/theme/Theme.h"

#include <QDir>
#include <QRegularExpression>

#include <cmath>

namespace limn {

Histogram sampleHistogram() {
  struct Peak {
    double centre, width, count;
  };
  const Peak peaks[] = {{-1000.0, 25.0, 3.5e6}, {-100.0, 40.0, 1.2e5}, {40.0, 30.0, 9.0e5},
                        {300.0, 260.0, 2.5e4},  {700.0, 320.0, 3.0e4}, {-600.0, 300.0, 2.0e4},
                        {2400.0, 350.0, 90.0}};
  Histogram histogram{{-1024.0, 3071.0}, std::vector<std::uint64_t>(1024, 0)};
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const double value = -1024.0 + (static_cast<double>(bin) + 0.5) * 4095.0 / 1024.0;
    double count = 0.0;
    for (const Peak& peak : peaks)
      count += peak.count * std::exp(-0.5 * std::pow((value - peak.centre) / peak.width, 2.0));
    histogram.counts[bin] = static_cast<std::uint64_t>(count);
  }
  return histogram;
}

TransferFunction sampleFunction() {
  return {1.0,
          {{-200.0, {0.86, 0.60, 0.46}, 0.0},
           {-60.0, {0.86, 0.60, 0.46}, 0.05},
           {60.0, {0.74, 0.28, 0.22}, 0.2},
           {300.0, {0.93, 0.82, 0.62}, 0.4},
           {1200.0, {1.0, 0.99, 0.94}, 0.9}}};
}

std::vector<Preset> samplePresets() {
  const auto preset = [](const char* name, const char* modality, const char* note,
                         TransferFunction function) {
    Preset made;
    made.name = name;
    made.modality = modality;
    made.note = note;
    made.transferFunction = std::move(function);
    return made;
  };
  return {
      preset("CT skin and bone", "CT", "Skin as a veil over muscle and skull", sampleFunction()),
      preset("CT bone", "CT", "Skull and teeth alone",
             {1.0,
              {{150.0, {0.7, 0.3, 0.2}, 0.0}, {350.0, {0.95, 0.85, 0.65}, 0.6}, {2000.0, {1, 1, 1}, 0.95}}}),
      preset("CT lung", "CT", "Airways and vessels of the lung",
             {1.0,
              {{-950.0, {0.2, 0.3, 0.5}, 0.0},
               {-700.0, {0.5, 0.7, 0.9}, 0.15},
               {-500.0, {0.9, 0.5, 0.4}, 0.0}}}),
      preset("MR head", "MR", "Skin and brain surface of T1 pictures",
             {1.0,
              {{30.0, {0.3, 0.2, 0.2}, 0.0}, {180.0, {0.9, 0.7, 0.6}, 0.4}, {400.0, {1, 0.95, 0.9}, 0.8}}})};
}

QStringList iconNames() {
  loadWidgetResources();
  QStringList names = QDir(QStringLiteral(":/limn/icons")).entryList({QStringLiteral("*.svg")});
  names = names.filter(QRegularExpression(QStringLiteral("^(?!check|chevron)")));
  for (QString& name : names)
    name.chop(4);
  return names;
}

} // namespace limn
