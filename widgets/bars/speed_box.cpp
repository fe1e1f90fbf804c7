#include "widgets/bars/speed_box.h"

#include <algorithm>
#include <cmath>

namespace usar::widgets {

SpeedBox::SpeedBox(QWidget* parent) : QComboBox(parent) {
    for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
        addItem(QStringLiteral("%1×").arg(speed), speed);
    addItem(tr("max"), double(INFINITY));
    setSpeed(1.0);
}

void SpeedBox::setSpeed(double speed) {
    const auto off = [&](int row) { return std::abs(std::log(itemData(row).toDouble() / speed)); };
    int nearest = std::isinf(speed) ? count() - 1 : 0;
    for (int i = 1; i < count() && std::isfinite(speed); ++i)
        if (off(i) < off(nearest))
            nearest = i;
    setCurrentIndex(nearest);
}

void SpeedBox::step(int entries) {
    setCurrentIndex(std::clamp(currentIndex() + entries, 0, count() - 1));
}

} // namespace usar::widgets
