// The map's layers as a list, which is its legend too: a swatch, an eye and an opacity each.
#pragma once

#include <array>

#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "widgets/map_content.h"

class QGridLayout;

namespace usar::widgets {

/// Top layer first; under the marks each kind with its color and shape. Begins with what a new map shows. For a dock or
/// a popup under the layers button. GUI thread.
class LayersPanel : public QWidget {
    Q_OBJECT
public:
    explicit LayersPanel(QWidget* parent = nullptr);

    /// Shows the state without telling it back.
    void setLayer(MapLayer layer, const LayerState& state);
    /// As it is set now; opacity in whole per cent.
    LayerState layer(MapLayer layer) const;

    /// Eyes and opacities as JSON by the layers' names, for the settings.
    QByteArray saveState() const;
    /// Emits layerChanged for each layer that becomes another; layers it does not name stay. False, and nothing
    /// changes, where `state` was not made by saveState.
    bool restoreState(const QByteArray& state);

signals:
    /// By the person only, at every step of a slider.
    void layerChanged(usar::widgets::MapLayer layer, const usar::widgets::LayerState& state);

private:
    /// Returns the line of the grid after the layer's own.
    int addLayer(MapLayer layer, int line);
    int addMarkLegend(int line);
    /// One line of the list; both are children of the panel.
    struct Row {
        QToolButton* eye = nullptr;
        QSlider* opacity = nullptr;
    };
    QGridLayout* grid_ = nullptr;
    std::array<Row, map_layer_count> rows_;
};

} // namespace usar::widgets
