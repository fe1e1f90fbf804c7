// How a layer or a mark looks on the map, as a small picture beside its name: the map's legend.
#pragma once

#include <variant>

#include <QWidget>

#include "widgets/map_content.h"

namespace usar::widgets {

/// Drawn by the same functions and in the same colors as the map, in both themes. What has the color of its robot is
/// shown in that of robot 1. Takes no focus, because the word beside it is what assistive tools read. GUI thread.
class LayerSwatch : public QWidget {
    Q_OBJECT
public:
    using What = std::variant<MapLayer, agent::MarkKind>;
    explicit LayerSwatch(const What& what, QWidget* parent = nullptr);
    QSize sizeHint() const override { return {32, 20}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    What what_;
};

} // namespace usar::widgets
