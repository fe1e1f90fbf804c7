// The one red button: stops all robots at once.
#pragma once

#include <QPushButton>

namespace usar::widgets {

/// Always enabled, never asks back. `clicked` is the order; Escape twice is the other way to it.
class StopButton : public QPushButton {
    Q_OBJECT
public:
    explicit StopButton(QWidget* parent = nullptr);
};

} // namespace usar::widgets
