// Small picture of a map layer or mark beside its name; together they are the map's legend.
#pragma once

#include <variant>

#include <QWidget>

#include "widgets/map/map_content.h"

namespace usar::widgets {

/// Drawn by the same functions and in the same colors as the map, in both themes. Whatever takes its color from a robot
/// is shown in the color of robot 1. Takes no focus, because assistive tools read the name beside it. GUI thread.
class LayerSwatch : public QWidget {
    Q_OBJECT
public:
    /// The layer or the kind of mark that is shown.
    using What = std::variant<MapLayer, agent::MarkKind>;
    explicit LayerSwatch(const What& what, QWidget* parent = nullptr);
    QSize sizeHint() const override { return {32, 20}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    What what_;
};

} // namespace usar::widgets
