#include "widgets/map/layers_panel.h"

#include <QGridLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalBlocker>

#include "widgets/map/layer_swatch.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {
const QString visible_key = QStringLiteral("visible");
const QString opacity_key = QStringLiteral("opacity");
} // namespace

LayersPanel::LayersPanel(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Map layers"));
    grid_ = new QGridLayout(this);
    grid_->setContentsMargins(gap::small, gap::small, gap::small, gap::small);
    grid_->setHorizontalSpacing(gap::small);
    grid_->setVerticalSpacing(gap::tiny);
    grid_->setColumnStretch(3, 1);
    int line = 0;
    for (std::size_t i = map_layer_count; i-- > 0;) {
        const auto layer = static_cast<MapLayer>(i);
        line = addLayer(layer, line);
        if (layer == MapLayer::Marks)
            line = addMarkLegend(line);
        setLayer(layer, firstLayers()[i]);
    }
    grid_->setRowStretch(line, 1);
}

int LayersPanel::addLayer(MapLayer layer, int line) {
    const QString name = layerName(layer);
    Row& row = rows_[static_cast<std::size_t>(layer)];
    row.eye = new QToolButton(this);
    row.eye->setCheckable(true);
    makeFlat(row.eye);
    named(row.eye, tr("Show %1").arg(name), tr("Shows or hides the layer %1").arg(name));
    row.opacity = new QSlider(Qt::Horizontal, this);
    row.opacity->setRange(10, 100);
    row.opacity->setMinimumWidth(80);
    row.opacity->setAccessibleName(tr("Opacity of %1").arg(name));
    grid_->addWidget(row.eye, line, 0);
    grid_->addWidget(new LayerSwatch(layer, this), line, 1);
    grid_->addWidget(new QLabel(name, this), line, 2);
    grid_->addWidget(row.opacity, line, 3);
    const auto tell = [this, layer] {
        const LayerState state = this->layer(layer);
        setLayer(layer, state);
        emit layerChanged(layer, state);
    };
    connect(row.eye, &QToolButton::clicked, this, tell);
    connect(row.opacity, &QSlider::valueChanged, this, tell);
    return line + 1;
}

int LayersPanel::addMarkLegend(int line) {
    for (const agent::MarkKind kind : all_mark_kinds) {
        grid_->addWidget(new LayerSwatch(kind, this), line, 1);
        grid_->addWidget(mutedLabel(markName(kind), this), line, 2, 1, 2);
        ++line;
    }
    return line;
}

void LayersPanel::setLayer(MapLayer layer, const LayerState& state) {
    Row& row = rows_[static_cast<std::size_t>(layer)];
    const QSignalBlocker quiet(row.opacity);
    row.eye->setChecked(state.visible);
    row.eye->setIcon(icon(state.visible ? QStringLiteral("eye") : QStringLiteral("eye-off")));
    row.opacity->setValue(qRound(state.opacity * 100.0));
    row.opacity->setEnabled(state.visible);
    row.opacity->setToolTip(tr("Opacity: %1 %").arg(row.opacity->value()));
}

LayerState LayersPanel::layer(MapLayer layer) const {
    const Row& row = rows_[static_cast<std::size_t>(layer)];
    return {row.eye->isChecked(), row.opacity->value() / 100.0};
}

QByteArray LayersPanel::saveState() const {
    QJsonObject layers;
    for (std::size_t i = 0; i < map_layer_count; ++i) {
        const LayerState state = layer(static_cast<MapLayer>(i));
        layers[layerName(static_cast<MapLayer>(i))] =
            QJsonObject{{visible_key, state.visible}, {opacity_key, state.opacity}};
    }
    return QJsonDocument(layers).toJson(QJsonDocument::Compact);
}

bool LayersPanel::restoreState(const QByteArray& state) {
    const QJsonDocument document = QJsonDocument::fromJson(state);
    if (!document.isObject())
        return false;
    for (std::size_t i = 0; i < map_layer_count; ++i) {
        const auto which = static_cast<MapLayer>(i);
        const LayerState before = layer(which);
        const QJsonObject saved = document.object()[layerName(which)].toObject();
        setLayer(which, {saved[visible_key].toBool(before.visible), saved[opacity_key].toDouble(before.opacity)});
        if (layer(which) != before)
            emit layerChanged(which, layer(which));
    }
    return true;
}

} // namespace usar::widgets
