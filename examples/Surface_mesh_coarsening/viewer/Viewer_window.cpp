// SPDX-License-Identifier: GPL-3.0-or-later

#include "Viewer_window.h"

#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <QKeyEvent>

#include <algorithm>
#include <cmath>
#include <exception>

namespace coarsening_viewer {

constexpr int slider_steps = 1000;

Viewer_window::Viewer_window(const Mesh& input, const std::string& name, std::size_t vertices)
  : name_(name),
    numbers_(vertex_numbers(input)),
    scenes_(input),
    task_(input)
{
  auto* rows = new QVBoxLayout(this);
  auto* pictures = new QHBoxLayout();
  auto* controls = new QHBoxLayout();
  rows->addLayout(pictures, 1);
  rows->addLayout(controls);
  state_ = new QLabel("Mouse or arrows: turn; wheel: zoom; Z: another axis points up; W, P: next weight, placement; +, -: more, "
                      "fewer vertices");
  rows->addWidget(state_);
  add_panels(*pictures);
  add_controls(*controls);
  delay_.setSingleShot(true);
  delay_.setInterval(200);
  connect(&delay_, &QTimer::timeout, this, [this] { start(); });
  clock_.setInterval(50);
  connect(&clock_, &QTimer::timeout, this, [this] { look_for_result(); });
  clock_.start();
  resize(1360, 480);
  setFocusPolicy(::Qt::StrongFocus);
  choose_vertices(vertices > 0 ? vertices : input.number_of_vertices() / 20);
}

void Viewer_window::add_panels(QBoxLayout& layout)
{
  for (std::size_t i = 0; i < number_of_panels; ++i) {
    auto* column = new QVBoxLayout();
    captions_[i] = new QLabel();
    captions_[i]->setWordWrap(true);
    captions_[i]->setMinimumHeight(3 * captions_[i]->fontMetrics().height());
    panels_[i] = new Panel(scenes_, i, view_, [this](bool coarsely) { show_view(coarsely); });
    column->addWidget(captions_[i]);
    column->addWidget(panels_[i], 1);
    layout.addLayout(column, 1);
    captions_[i]->setText(QString::fromStdString(scenes_.caption(i)));
  }
}

void Viewer_window::add_controls(QBoxLayout& layout)
{
  slider_ = new QSlider(::Qt::Horizontal);
  slider_->setRange(0, slider_steps);
  slider_->setFocusPolicy(::Qt::NoFocus); // keys are the window's
  number_ = new QSpinBox();
  number_->setRange(int(numbers_.first), int(numbers_.second));
  number_->setFocusPolicy(::Qt::ClickFocus);
  number_->setKeyboardTracking(false);
  weight_ = new QComboBox();
  for (const char* name : weight_names)
    weight_->addItem(QString("weight ") + name);
  placement_ = new QComboBox();
  for (const char* name : placement_names)
    placement_->addItem(QString("placement ") + name);
  const Choice defaults;
  weight_->setCurrentIndex(int(defaults.weight));
  placement_->setCurrentIndex(int(defaults.placement));
  for (QComboBox* box : {weight_, placement_}) {
    box->setFocusPolicy(::Qt::NoFocus);
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] { start(); });
  }
  connect(slider_, &QSlider::valueChanged, this, [this](int at) { choose_vertices(number_at(at)); });
  connect(number_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this](int n) {
    choose_vertices(std::size_t(n));
    setFocus();
  });
  for (QWidget* widget : {static_cast<QWidget*>(new QLabel("vertices")), static_cast<QWidget*>(slider_),
                          static_cast<QWidget*>(number_), static_cast<QWidget*>(weight_), static_cast<QWidget*>(placement_)})
    layout.addWidget(widget);
}

// The slider's steps are equal ratios.
int Viewer_window::slider_position(std::size_t number) const
{
  const double whole = std::log(double(numbers_.second) / double(numbers_.first));
  return whole > 0 ? int(std::lround(slider_steps * std::log(double(number) / double(numbers_.first)) / whole)) : 0;
}

std::size_t Viewer_window::number_at(int position) const
{
  const double ratio = double(numbers_.second) / double(numbers_.first);
  return std::size_t(std::lround(double(numbers_.first) * std::pow(ratio, double(position) / slider_steps)));
}

void Viewer_window::choose_vertices(std::size_t number)
{
  const std::size_t n = (std::min)((std::max)(number, numbers_.first), numbers_.second);
  slider_->blockSignals(true);
  number_->blockSignals(true);
  slider_->setValue(slider_position(n));
  number_->setValue(int(n));
  slider_->blockSignals(false);
  number_->blockSignals(false);
  delay_.start();
}

void Viewer_window::start()
{
  Choice choice;
  choice.vertices = std::size_t(number_->value());
  choice.weight = std::size_t(weight_->currentIndex());
  choice.placement = std::size_t(placement_->currentIndex());
  say("coarsening");
  task_.start(choice);
}

void Viewer_window::say(const std::string& what)
{
  setWindowTitle(QString::fromStdString("coarsening_viewer " + name_ + ": " + what));
}

void Viewer_window::look_for_result()
{
  if (!task_.is_running())
    return;
  say(task_.progress());
  try {
    const std::optional<Coarse> coarse = task_.result();
    if (!coarse)
      return;
    scenes_.show(*coarse);
    for (std::size_t i = 0; i < number_of_panels; ++i)
      captions_[i]->setText(QString::fromStdString(scenes_.caption(i)));
    show_view(false);
    say(std::to_string(coarse->mesh.number_of_vertices()) + " vertices, weight " + weight_names[coarse->choice.weight] +
        ", placement " + placement_names[coarse->choice.placement]);
  } catch (const std::exception& e) {
    say("no result");
    state_->setText(e.what());
  }
}

void Viewer_window::show_view(bool coarsely)
{
  for (Panel* panel : panels_)
    panel->draw(coarsely);
}

void Viewer_window::keyPressEvent(QKeyEvent* event)
{
  constexpr double step = 0.1, steepest = 1.5;
  const auto next = [](QComboBox& box) { box.setCurrentIndex((box.currentIndex() + 1) % box.count()); };
  const std::size_t n = std::size_t(number_->value());
  switch (event->key()) {
  case ::Qt::Key_W:
    next(*weight_);
    return;
  case ::Qt::Key_P:
    next(*placement_);
    return;
  case ::Qt::Key_Plus:
    choose_vertices(n + n / 4);
    return;
  case ::Qt::Key_Minus:
    choose_vertices(n - n / 5);
    return;
  case ::Qt::Key_Left:
    view_.turn += step;
    break;
  case ::Qt::Key_Right:
    view_.turn -= step;
    break;
  case ::Qt::Key_Up:
    view_.tilt = (std::max)(view_.tilt - step, -steepest);
    break;
  case ::Qt::Key_Down:
    view_.tilt = (std::min)(view_.tilt + step, steepest);
    break;
  case ::Qt::Key_Z:
    view_.z_is_up = !view_.z_is_up;
    break;
  default:
    QWidget::keyPressEvent(event);
    return;
  }
  show_view(false);
}

} // namespace coarsening_viewer
