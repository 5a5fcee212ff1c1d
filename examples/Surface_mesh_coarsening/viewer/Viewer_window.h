// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_VIEWER_VIEWER_WINDOW_H
#define COARSENING_VIEWER_VIEWER_WINDOW_H

#include "Coarsening_task.h"
#include "Panel.h"
#include "panels.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <QTimer>
#include <QWidget>

#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace coarsening_viewer {

// Input, clusters, result and error side by side, and below them the number of vertices, the weight and the placement. Its title
// tells what is shown, or how far the coarsening is.
class Viewer_window : public QWidget
{
public:
  // `vertices` is 0 for a part of the input's.
  Viewer_window(const Mesh& input, const std::string& name, std::size_t vertices);

protected:
  void keyPressEvent(QKeyEvent* event) override;

private:
  void add_panels(QBoxLayout& layout);
  void add_controls(QBoxLayout& layout);
  void choose_vertices(std::size_t number);
  int slider_position(std::size_t number) const;
  std::size_t number_at(int position) const;
  void start();
  void look_for_result();
  void show_view(bool coarsely);
  void say(const std::string& what);

  const std::string name_;
  const std::pair<std::size_t, std::size_t> numbers_; // of vertices, least and most
  Panel_scenes scenes_;
  View view_;
  std::array<Panel*, number_of_panels> panels_; // which the window owns, as all widgets
  std::array<QLabel*, number_of_panels> captions_;
  QSlider* slider_;
  QSpinBox* number_;
  QComboBox *weight_, *placement_;
  QLabel* state_;
  QTimer delay_, clock_;
  Coarsening_task task_;
};

} // namespace coarsening_viewer

#endif // COARSENING_VIEWER_VIEWER_WINDOW_H
