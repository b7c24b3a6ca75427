// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/ChoiceRow.h"

#include <QAbstractItemView>
#include <QPixmap>
#include <QStyleOptionComboBox>

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(QuietComboBox, wordsThatFindNoRoomEndInAnEllipsis) {
  struct Shown : QuietComboBox {
    QString words() const {
      QStyleOptionComboBox option;
      initStyleOption(&option);
      return option.currentText;
    }
  } box;
  const QString whole = QStringLiteral("Background of the head");
  QPixmap swatch(12, 12);
  swatch.fill(Qt::red);
  box.addItem(swatch, whole);
  box.resize(400, 28);
  EXPECT_EQ(box.words(), whole);
  box.resize(90, 28);
  EXPECT_TRUE(box.words().endsWith(QChar(0x2026))) << box.words().toStdString();
  EXPECT_TRUE(whole.startsWith(box.words().chopped(1)));
}

TEST(QuietComboBox, theRowsOfItsListHaveRoomAroundTheirWords) {
  QuietComboBox box;
  box.addItems({QStringLiteral("Headlight"), QStringLiteral("Studio")});
  box.show();
  box.showPopup();
  EXPECT_GE(box.view()->visualRect(box.model()->index(0, 0)).height(), box.fontMetrics().height() + 8);
  box.hidePopup();
}

} // namespace
} // namespace limn
