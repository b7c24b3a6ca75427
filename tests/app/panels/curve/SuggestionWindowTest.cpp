// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/panels/curve/SuggestionDialog.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/view/CompareView.h"

#include <QPointer>
#include <QPushButton>

#include <algorithm>

// Bands proposed for the boundaries of what is open, in the program's window.

namespace limn {
namespace {

class SuggestionWindow : public test::WindowHarness {
protected:
  // Asks for proposals and waits for them.
  [[nodiscard]] bool suggest() {
    window->findChild<QAction*>(QStringLiteral("suggest"))->trigger();
    return test::waitUntil([this] { return !buttons().empty(); });
  }

  SuggestionDialog& dialog() const { return *window->findChild<SuggestionDialog*>(); }

  QList<QPushButton*> buttons() const {
    QList<QPushButton*> found;
    if (const auto* shown = window->findChild<SuggestionDialog*>())
      for (QPushButton* button : shown->findChildren<QPushButton*>())
        if (button->accessibleName().startsWith(QStringLiteral("Use the band")))
          found << button;
    return found;
  }

  // Of bands that the curve does not show yet.
  QPushButton* usable() const {
    const QList<QPushButton*> all = buttons();
    const auto found = std::ranges::find_if(all, [](const QPushButton* one) { return one->isEnabled(); });
    return found == all.end() ? nullptr : *found;
  }

  // A curve that shows nothing.
  void clearCurve() {
    session().setTransferFunction({1.0, {{0.0, {1, 1, 1}, 0.0}}},
                                  {nextGestureId(), QStringLiteral("nothing")});
  }

  QPushButton* buttonNamed(const QString& name) const {
    for (QPushButton* button : buttons())
      if (button->accessibleName().contains(name))
        return button;
    return nullptr;
  }

  void pointAt(QWidget& row, bool isInside) {
    const QPointF centre = QRectF(row.rect()).center();
    if (isInside) {
      QEnterEvent enter(centre, centre, row.mapToGlobal(centre));
      QCoreApplication::sendEvent(&row, &enter);
    } else {
      QEvent leave(QEvent::Leave);
      QCoreApplication::sendEvent(&row, &leave);
    }
  }
};

TEST_F(SuggestionWindow, proposesSkinAndBoneForAHead) {
  ASSERT_TRUE(open(QStringLiteral("phantom:1.5")));
  ASSERT_TRUE(suggest());
  EXPECT_TRUE(buttonNamed(QStringLiteral("Skin")));
  EXPECT_TRUE(buttonNamed(QStringLiteral("Bone")));
}

TEST(SuggestionWords, saysAPlaceOnce) {
  const Boundary boundary{92.0, 130.0, 0.22};
  EXPECT_EQ(boundaryName(boundary, {}), QStringLiteral("Surface at 111"));
  EXPECT_EQ(boundaryExplained(boundary, {}), QStringLiteral("Between 92 and 130; 22 % of all boundaries"));
  const Boundary bone{40.0, 600.0, 0.05};
  const ValueNames names{QStringLiteral("HU"), true};
  EXPECT_EQ(boundaryName(bone, names), QStringLiteral("Bone"));
  EXPECT_TRUE(
      boundaryExplained(bone, names).startsWith(QStringLiteral("Surface at 320\u00a0HU, between 40 and")))
      << boundaryExplained(bone, names).toStdString();
}

TEST_F(SuggestionWindow, aRowUnderThePointerIsSeenAndLeavesNothingBehind) {
  ASSERT_TRUE(open(QStringLiteral("phantom:3")));
  clearCurve();
  ASSERT_TRUE(suggest());
  const Scene before = scene();
  const int steps = session().undoStack().count();
  QWidget& row = *buttons().front()->parentWidget();
  pointAt(row, true);
  EXPECT_NE(view().scene().transferFunction, before.transferFunction) << "the picture";
  EXPECT_EQ(curves().valueEditor()->canvas()->transferFunction(), view().scene().transferFunction)
      << "the curve";
  EXPECT_EQ(scene(), before) << "what is edited";
  pointAt(row, false);
  EXPECT_EQ(view().scene(), before);
  EXPECT_EQ(curves().valueEditor()->canvas()->transferFunction(), before.transferFunction);
  EXPECT_EQ(session().undoStack().count(), steps);
}

TEST_F(SuggestionWindow, oneIsTakenOverByMouseOrKeyInOneStep) {
  ASSERT_TRUE(open(QStringLiteral("phantom:3")));
  clearCurve();
  ASSERT_TRUE(suggest());
  const TransferFunction before = scene().transferFunction;
  QPushButton* const used = usable();
  QTest::mouseClick(used, Qt::LeftButton);
  EXPECT_FALSE(used->isEnabled()) << "the curve shows it";
  EXPECT_EQ(view().scene(), scene())
      << "and the next row, which has the focus now, is not shown in its place";
  EXPECT_EQ(used->text(), QStringLiteral("In the curve"));
  const TransferFunction first = scene().transferFunction;
  EXPECT_NE(first, before);
  EXPECT_TRUE(session().undoStack().undoText().startsWith(QStringLiteral("use the band")))
      << session().undoStack().undoText().toStdString();
  ASSERT_TRUE(usable());
  usable()->setFocus();
  QTest::keyClick(usable(), Qt::Key_Space);
  EXPECT_NE(scene().transferFunction, first);
  session().undoStack().undo();
  EXPECT_EQ(scene().transferFunction, first);
  session().undoStack().undo();
  EXPECT_EQ(scene().transferFunction, before);
  EXPECT_TRUE(used->isEnabled()) << "it does not show it any more";
}

TEST_F(SuggestionWindow, closingEndsThePreviewAndAnotherVolumeIsLookedAtAnew) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  clearCurve();
  ASSERT_TRUE(suggest());
  const Scene before = scene();
  pointAt(*buttons().front()->parentWidget(), true);
  ASSERT_NE(view().scene(), before);
  dialog().close();
  EXPECT_EQ(view().scene(), before);
  ASSERT_TRUE(suggest());
  const QPointer<QPushButton> old = buttons().front(); // another may get its address
  ASSERT_TRUE(open(QStringLiteral("phantom:3")));
  EXPECT_TRUE(test::waitUntil([&] { return !old && !buttons().empty(); }));
  window->findChild<QAction*>(QStringLiteral("closeVolume"))->trigger();
  EXPECT_FALSE(dialog().isVisible());
}

// In the neck there is none of the skull and its cavities.
TEST_F(SuggestionWindow, whatIsHiddenProposesNothingAndACropIsLookedAtAnew) {
  ASSERT_TRUE(open(QStringLiteral("phantom:3")));
  ASSERT_TRUE(suggest());
  const auto explained = [this] {
    QString all;
    for (const QLabel* label : dialog().findChildren<QLabel*>())
      all += label->text();
    return all;
  };
  const QString whole = explained();
  session().setCrop({{0.0, 0.0, 0.0}, {1.0, 1.0, 0.3}}, {nextGestureId(), QStringLiteral("crop")});
  EXPECT_TRUE(test::waitUntil([&] { return !buttons().empty() && explained() != whole; }));
  undo().undo();
  EXPECT_TRUE(test::waitUntil([&] { return !buttons().empty() && explained() == whole; }));
}

} // namespace
} // namespace limn
