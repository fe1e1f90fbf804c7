// List of the map's layers, which is also its legend: each has a swatch, a visibility button and an opacity slider.
#pragma once

#include <array>
#include <variant>

#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "widgets/map/height_controls.h"
#include "widgets/map/map_content.h"

class QGridLayout;

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

/// The top layer comes first; below the marks, each kind of mark is listed with its color and shape. Starts with the
/// layers of a new map. For a dock or a popup below the layers button. GUI thread.
class LayersPanel : public QWidget {
    Q_OBJECT
public:
    explicit LayersPanel(QWidget* parent = nullptr);

    /// Shows the state without emitting layerChanged. Opacity below 10 % is shown as 10 %.
    void setLayer(MapLayer layer, const LayerState& state);
    /// The state as shown; opacity is rounded to whole percent.
    LayerState layer(MapLayer layer) const;

    /// Colors and range of the height map.
    HeightControls* heightControls() const { return heights_; }

    /// Visibility and opacity of all layers and the look of the heights as JSON, keyed by the layers' names; for the
    /// settings.
    QByteArray saveState() const;
    /// Emits layerChanged for each layer that changes; layers that `state` does not name keep theirs. Returns false and
    /// changes nothing if `state` is not a JSON object.
    bool restoreState(const QByteArray& state);

signals:
    /// By the user only; while a slider is dragged, at each of its steps.
    void layerChanged(usar::widgets::MapLayer layer, const usar::widgets::LayerState& state);
    /// The user has changed a layer, or the look of the heights; after the signal that tells this change. `what`: the
    /// name of the layer. The states are those of `saveState`.
    void edited(const QString& what, const QByteArray& before, const QByteArray& after);

private:
    /// Appends the layer's row at `line` of the grid; returns the next free line.
    int addLayer(MapLayer layer, int line);
    /// Appends the kinds of marks from `line` on; returns the next free line.
    int addMarkLegend(int line);
    /// Widgets of one layer; both are children of the panel.
    struct Row {
        QToolButton* eye = nullptr;
        QSlider* opacity = nullptr;
    };
    /// Emits `edited`, unless a state is being restored.
    void tellEdit(const QString& what);

    QGridLayout* grid_ = nullptr;
    HeightControls* heights_ = nullptr;
    std::array<Row, map_layer_count> rows_;
    QByteArray told_;        ///< the state before the next edit
    bool restoring_ = false; ///< what changes now is no edit
};

} // namespace usar::widgets
