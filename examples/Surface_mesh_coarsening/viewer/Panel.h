// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_VIEWER_PANEL_H
#define COARSENING_VIEWER_PANEL_H

#include "panels.h"

#include <QImage>
#include <QWidget>

#include <functional>

namespace coarsening_viewer {

// One of the pictures. All have one view, which the mouse changes in any of them.
class Panel : public QWidget
{
  const Panel_scenes& scenes_;
  const std::size_t number_;
  View& view_;
  const std::function<void(bool)> view_changed_;
  QImage image_;
  QPoint mouse_;

public:
  // `view_changed` is told whether the change goes on.
  Panel(const Panel_scenes& scenes, std::size_t number, View& view, std::function<void(bool)> view_changed);

  // Draws the picture, coarsely while the mouse turns it.
  void draw(bool coarsely);

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
};

} // namespace coarsening_viewer

#endif // COARSENING_VIEWER_PANEL_H
