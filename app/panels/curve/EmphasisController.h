// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <optional>

namespace limn {

class PointLight;
class TransferFunctionCanvas;
struct WindowContext;

/// Shows what a point of the curve governs for as long as the pointer rests on it: in the slices and in the
/// picture, and in no history.
class EmphasisController : public QObject {
  Q_OBJECT

public:
  EmphasisController(WindowContext& context, TransferFunctionCanvas& canvas);

signals:
  /// The slices are to light up what this point governs, or nothing.
  void lit(std::optional<std::size_t> point);

private:
  void show(std::optional<std::size_t> point);

  WindowContext& m_context;
  PointLight* m_light;
};

} // namespace limn
