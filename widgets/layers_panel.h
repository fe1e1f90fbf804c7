// The map's layers as a list: an eye and an opacity each.
#pragma once

#include <array>

#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "widgets/map_content.h"

namespace usar::widgets {

/// Top layer first. For a dock or a popup under the layers button. GUI thread.
class LayersPanel : public QWidget {
    Q_OBJECT
public:
    explicit LayersPanel(QWidget* parent = nullptr);

    void setLayer(MapLayer layer, const LayerState& state);
    LayerState layer(MapLayer layer) const;

signals:
    void layerChanged(usar::widgets::MapLayer layer, const usar::widgets::LayerState& state);

private:
    struct Row {
        QToolButton* eye = nullptr;
        QSlider* opacity = nullptr;
    };
    std::array<Row, map_layer_count> rows_;
};

} // namespace usar::widgets
