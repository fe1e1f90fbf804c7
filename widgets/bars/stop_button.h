// The red button that stops all robots at once.
#pragma once

#include <QPushButton>

namespace usar::widgets {

/// Always enabled, and never asks for confirmation. `clicked` means stop; pressing Escape twice does the same.
class StopButton : public QPushButton {
    Q_OBJECT
public:
    explicit StopButton(QWidget* parent = nullptr);
};

} // namespace usar::widgets
