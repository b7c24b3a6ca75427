// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAccessible>
#include <QPointer>
#include <QWidget>

namespace limn {

/// A part of a widget that paints itself, such as one of two handles, as assistive technology finds it: a
/// slider with a name and a number. Like the cells of Qt's tables it is no object of its own.
class AccessiblePart : public QAccessibleInterface,
                       public QAccessibleValueInterface,
                       public QAccessibleActionInterface {
public:
  explicit AccessiblePart(QWidget& owner) : m_owner(&owner) {}

  bool isValid() const override { return m_owner != nullptr; }
  QObject* object() const override { return nullptr; }
  QAccessibleInterface* parent() const override { return QAccessible::queryAccessibleInterface(m_owner); }
  QWindow* window() const override;
  QAccessibleInterface* child(int) const override { return nullptr; }
  QAccessibleInterface* childAt(int, int) const override { return nullptr; }
  int childCount() const override { return 0; }
  int indexOfChild(const QAccessibleInterface*) const override { return -1; }
  QAccessible::Role role() const override { return QAccessible::Slider; }
  void setText(QAccessible::Text, const QString&) override {}

  /// On the screen, pixels: a square around the centre.
  QRect rect() const override;

  /// That of the widget, but the focus is the part's own.
  QAccessible::State state() const override;

  /// One action: the part takes the focus where the widget is enabled.
  QStringList actionNames() const override { return {setFocusAction()}; }
  QStringList keyBindingsForAction(const QString&) const override { return {}; }
  void doAction(const QString& name) override;

  /// A finite number for an enabled widget goes to setNumber.
  void setCurrentValue(const QVariant& value) override;

  void* interface_cast(QAccessible::InterfaceType type) override;

protected:
  /// In the widget, pixels.
  virtual QPointF centre() const = 0;
  virtual bool hasFocus() const = 0;
  virtual void takeFocus() = 0;
  virtual void setNumber(double number) = 0;

private:
  QPointer<QWidget> m_owner;
};

} // namespace limn
