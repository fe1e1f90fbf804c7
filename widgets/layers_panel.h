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

    /// Shows the state without telling it back.
    void setLayer(MapLayer layer, const LayerState& state);
    /// As it is set now; opacity in whole per cent.
    LayerState layer(MapLayer layer) const;

signals:
    /// By the person only, at every step of a slider.
    void layerChanged(usar::widgets::MapLayer layer, const usar::widgets::LayerState& state);

private:
    /// One line of the list; both are children of the panel.
    struct Row {
        QToolButton* eye = nullptr;
        QSlider* opacity = nullptr;
    };
    std::array<Row, map_layer_count> rows_;
};

} // namespace usar::widgets
