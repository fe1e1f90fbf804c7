#include "widgets/layers_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "widgets/icons.h"
#include "widgets/theme.h"

namespace usar::widgets {

LayersPanel::LayersPanel(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Map layers"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(gap::small, gap::small, gap::small, gap::small);
    grid->setHorizontalSpacing(gap::small);
    grid->setVerticalSpacing(gap::tiny);
    for (std::size_t i = 0; i < map_layer_count; ++i) {
        const auto layer = static_cast<MapLayer>(i);
        const QString name = layerName(layer);
        Row& row = rows_[i];
        row.eye = new QToolButton(this);
        row.eye->setCheckable(true);
        row.eye->setAutoRaise(true);
        row.eye->setMinimumSize(minimum_target, minimum_target);
        row.eye->setAccessibleName(tr("Show %1").arg(name));
        row.eye->setToolTip(tr("Shows or hides the layer %1").arg(name));
        row.opacity = new QSlider(Qt::Horizontal, this);
        row.opacity->setRange(10, 100);
        row.opacity->setMinimumWidth(80);
        row.opacity->setAccessibleName(tr("Opacity of %1").arg(name));
        row.opacity->setToolTip(tr("Opacity in per cent"));
        const int line = static_cast<int>(map_layer_count - i);
        grid->addWidget(row.eye, line, 0);
        grid->addWidget(new QLabel(name, this), line, 1);
        grid->addWidget(row.opacity, line, 2);
        setLayer(layer, {});
        const auto tell = [this, layer] {
            const LayerState state = this->layer(layer);
            setLayer(layer, state);
            emit layerChanged(layer, state);
        };
        connect(row.eye, &QToolButton::clicked, this, tell);
        connect(row.opacity, &QSlider::valueChanged, this, tell);
    }
    grid->setRowStretch(static_cast<int>(map_layer_count) + 1, 1);
}

void LayersPanel::setLayer(MapLayer layer, const LayerState& state) {
    Row& row = rows_[static_cast<std::size_t>(layer)];
    const QSignalBlocker quiet(row.opacity);
    row.eye->setChecked(state.visible);
    row.eye->setIcon(icon(state.visible ? QStringLiteral("eye") : QStringLiteral("eye-off")));
    row.opacity->setValue(qRound(state.opacity * 100.0));
    row.opacity->setEnabled(state.visible);
}

LayerState LayersPanel::layer(MapLayer layer) const {
    const Row& row = rows_[static_cast<std::size_t>(layer)];
    return {row.eye->isChecked(), row.opacity->value() / 100.0};
}

} // namespace usar::widgets
