// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCheckBox>
#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include "colours.h"

/// Widgets whose text may be long and has to be readable in a narrow panel. Text is plain text:
/// names from PDDL must not be read as markup.
namespace goal_alignment::rviz_panel {

/// Wraps, and is always as high as its text needs at its width.
class WrappedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit WrappedLabel(QWidget* parent = nullptr);
  void setTone(Tone tone);
  void setLook(double size, bool bold);  // relative to the usual size
  /// Hidden while there is nothing to say.
  void say(const QString& text);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void fit();
  void paintTone();
  Tone tone_ = Tone::Plain;
};

/// A button whose text wraps.
class WrappedButton : public QPushButton {
  Q_OBJECT

 public:
  explicit WrappedButton(const QString& text, const QString& note, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  int heightFor(int width) const;
  WrappedLabel* text_;
  WrappedLabel* note_;
};

/// A tick box whose text wraps; a click on the text ticks it, too.
class TickBox : public QWidget {
  Q_OBJECT

 public:
  explicit TickBox(const QString& text, QWidget* parent = nullptr);
  bool isTicked() const { return box_->isChecked(); }

 signals:
  void toggled();

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  QCheckBox* box_;
};

/// A frame with a coloured edge and a tinted ground.
class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(Tone tone, QWidget* parent = nullptr);
  void setTone(Tone tone);

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  Tone tone_;
};

}  // namespace goal_alignment::rviz_panel
