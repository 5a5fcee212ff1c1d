// SPDX-License-Identifier: GPL-3.0-or-later

#include "Panel.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coarsening_viewer {

Panel::Panel(const Panel_scenes& scenes, std::size_t number, View& view, std::function<void(bool)> view_changed)
  : scenes_(scenes),
    number_(number),
    view_(view),
    view_changed_(std::move(view_changed))
{
  setMinimumSize(200, 200);
}

void Panel::draw(bool coarsely)
{
  constexpr int pixels_of_coarse = 3;
  const double side = (std::min)(width(), height()) * devicePixelRatioF(); // in pixels of the screen
  const int size = (std::max)(1, int(side) / (coarsely ? pixels_of_coarse : 1));
  const Image image = scenes_.image(number_, view_, std::size_t(size));
  image_ = QImage(int(image.width), int(image.height), QImage::Format_RGB32);
  for (std::size_t y = 0; y < image.height; ++y)
    for (std::size_t x = 0; x < image.width; ++x) {
      const Rgb& c = image.at(x, y);
      image_.setPixel(int(x), int(y), qRgb(c[0], c[1], c[2]));
    }
  update();
}

void Panel::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(rect(), ::Qt::white);
  const int size = (std::min)(width(), height());
  painter.drawImage(QRect((width() - size) / 2, (height() - size) / 2, size, size), image_);
}

void Panel::resizeEvent(QResizeEvent*) { draw(false); }

void Panel::mousePressEvent(QMouseEvent* event) { mouse_ = event->pos(); }

void Panel::mouseMoveEvent(QMouseEvent* event)
{
  constexpr double radians_per_pixel = 0.01, steepest = 1.5;
  const QPoint way = event->pos() - mouse_;
  mouse_ = event->pos();
  view_.turn -= radians_per_pixel * way.x();
  view_.tilt = (std::min)(steepest, (std::max)(-steepest, view_.tilt + radians_per_pixel * way.y()));
  view_changed_(true);
}

void Panel::mouseReleaseEvent(QMouseEvent*) { view_changed_(false); }

void Panel::wheelEvent(QWheelEvent* event)
{
  view_.zoom = (std::min)(50., (std::max)(0.5, view_.zoom * std::exp(event->angleDelta().y() / 600.)));
  view_changed_(false);
}

} // namespace coarsening_viewer
