// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCheckBox>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>

#include "colours.h"

/// Widgets whose text may be long and has to be readable in a narrow panel. Text is plain text:
/// names from PDDL must not be read as markup.
namespace goal_alignment::rviz_panel {

/// Wraps, and is as high as its text needs at its width.
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
  void changeEvent(QEvent* event) override;

 private:
  void paintTone();
  Tone tone_ = Tone::Plain;
};

/// A button whose text wraps.
class WrappedButton : public QPushButton {
  Q_OBJECT

 public:
  WrappedButton(const QString& text, const QString& note, QWidget* parent = nullptr);
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 private:
  WrappedLabel* text_;
  WrappedLabel* note_;
};

/// As high as what it holds needs at its width, up to a limit; from there on it scrolls.
class ShortScroll : public QScrollArea {
  Q_OBJECT

 public:
  /// In pixels.
  explicit ShortScroll(int most, QWidget* parent = nullptr);
  /// Replaces what it held before.
  void hold(QWidget* content);
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 private:
  int most_;
};

/// A tick box whose text wraps; a click on the text ticks it, too.
class TickBox : public QWidget {
  Q_OBJECT

 public:
  explicit TickBox(const QString& text, QWidget* parent = nullptr);
  bool isTicked() const { return box_->isChecked(); }
  void setTicked(bool ticked) { box_->setChecked(ticked); }

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
