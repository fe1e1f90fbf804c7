#include "widgets/map/layers_panel.h"

#include <utility>

#include <QJsonDocument>
#include <QJsonObject>
#include <QPainter>
#include <QScopedValueRollback>
#include <QSignalBlocker>

#include "core/mapping/shading.h"
#include "widgets/map/map_painter.h"
#include "widgets/map/scenery_painter.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/sheet.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

namespace usar::widgets {
namespace {

const QRectF frame(-13.0, -7.0, 26.0, 14.0); // Around the middle.

void paintGridSwatch(QPainter& painter) {
    painter.setPen(QPen(tokens().text_muted, 1.0));
    for (const double x : {-8.5, 0.5, 9.5})
        painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
    for (const double y : {-3.5, 3.5})
        painter.drawLine(QPointF(frame.left(), y), QPointF(frame.right(), y));
}

void paintContourSwatch(QPainter& painter) {
    painter.setPen(QPen(tokens().text, 1.0));
    painter.setBrush(Qt::NoBrush);
    for (const double r : {2.0, 4.5, 7.0})
        painter.drawEllipse(QPointF(), 1.8 * r, r);
}

void paintHeightSwatch(QPainter& painter) {
    const mapping::HeightRange range{0.0f, static_cast<float>(frame.width() - 1.0)};
    for (int i = 0; i < static_cast<int>(frame.width()); ++i)
        painter.fillRect(QRectF(frame.left() + i, frame.top(), 1.0, frame.height()),
                         QColor::fromRgba(mapping::shade(static_cast<float>(i), range, mapping::ColorMap::Color)));
}

void paintLaneSwatch(QPainter& painter) {
    painter.setPen(QPen(tokens().accent, 1.0));
    for (const double y : {-4.5, 0.5, 5.5})
        painter.drawLine(QPointF(frame.left(), y), QPointF(frame.right(), y));
}

void paintLaserSwatch(QPainter& painter) {
    painter.setPen(QPen(tokens().laser, 2.0));
    painter.drawPoints(QPolygonF({{-12, 1}, {-8, 2}, {-4, 1}, {0, -1}, {4, -3}, {8, -2}, {12, -3}}));
}

void paintGoalSwatch(QPainter& painter) {
    painter.setPen(dashedPen(robotColor(1), 1.5, {2.0, 3.0}));
    painter.drawLine(QPointF(frame.left(), 0.0), QPointF(1.0, 0.0));
    painter.setPen(QPen(robotColor(1), 2.0));
    painter.drawEllipse(QPointF(7.0, 0.0), 5.0, 5.0);
}

void paintTraceSwatch(QPainter& painter) {
    painter.setPen(QPen(QColor(0, 0, 0, 150), 1.0));
    for (const auto& [x, color] : {std::pair(-9.0, protocol::TraceColor::Red),
                                   {-3.0, protocol::TraceColor::Red},
                                   {3.0, protocol::TraceColor::Cyan},
                                   {9.0, protocol::TraceColor::Cyan}}) {
        painter.setBrush(traceColor(color));
        painter.drawEllipse(QPointF(x, 0.0), 2.5, 2.5);
    }
}

void paintLayer(QPainter& painter, MapLayer layer) {
    switch (layer) {
    case MapLayer::World:
        painter.setPen(QPen(tokens().text_muted, 1.0));
        painter.setBrush(tokens().ground);
        return painter.drawRect(frame);
    case MapLayer::Grid:
        return paintGridSwatch(painter);
    case MapLayer::Heights:
        return paintHeightSwatch(painter);
    case MapLayer::Contours:
        return paintContourSwatch(painter);
    case MapLayer::Area:
        painter.setPen(dashedPen(tokens().accent, 1.5, {4.0, 2.5}));
        return painter.drawRect(frame);
    case MapLayer::Lanes:
        return paintLaneSwatch(painter);
    case MapLayer::Trails:
        painter.setPen(QPen(robotColor(1), 1.5));
        return painter.drawPolyline(QPolygonF({{-13, 3}, {-4, -3}, {4, 3}, {13, -2}}));
    case MapLayer::Corrected:
        return paintCorrectedSwatch(painter, {});
    case MapLayer::Traces:
        return paintTraceSwatch(painter);
    case MapLayer::Objects:
        paintObjectSymbol(painter, QRectF(2.0, -5.0, 10.0, 10.0), false);
        painter.translate(-7.0, 0.0);
        return paintTree(painter, 6.0, 1.5);
    case MapLayer::Marks:
        paintMark(painter, agent::MarkKind::HighRisk, QPointF(-7.0, 0.0), 10.0);
        return paintMark(painter, agent::MarkKind::Diversion, QPointF(7.0, 0.0), 10.0);
    case MapLayer::StartPoses:
        painter.translate(-6.0, 0.0);
        painter.scale(0.8, 0.8);
        return paintStartPoseSymbol(painter, pi / 2.0, false);
    case MapLayer::Laser:
        return paintLaserSwatch(painter);
    case MapLayer::Goals:
        return paintGoalSwatch(painter);
    case MapLayer::Radio:
        painter.setPen(QPen(tokens().ok, 2.0));
        return painter.drawLine(QPointF(-12.0, 4.0), QPointF(12.0, -4.0));
    case MapLayer::Robots:
        painter.scale(0.8, 0.8);
        return paintRobotSymbol(painter, pi / 2.0, robotColor(1), false);
    }
}

const QString visible_key = QStringLiteral("visible");
const QString opacity_key = QStringLiteral("opacity");
const QString look_key = QStringLiteral("look of heights");

} // namespace

LayerSwatch::LayerSwatch(const What& what, QWidget* parent) : QWidget(parent), what_(what) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void LayerSwatch::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(QRectF(rect()).center());
    if (const auto* layer = std::get_if<MapLayer>(&what_))
        paintLayer(painter, *layer);
    else
        paintMark(painter, std::get<agent::MarkKind>(what_), QPointF(), 10.0);
}

LayersPanel::LayersPanel(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Map layers"));
    grid_ = gridOf(this, {gap::small, gap::small, gap::small, gap::small}, gap::small, gap::tiny);
    grid_->setColumnStretch(3, 1);
    int line = 0;
    for (std::size_t i = map_layer_count; i-- > 0;) {
        const auto layer = static_cast<MapLayer>(i);
        line = addLayer(layer, line);
        if (layer == MapLayer::Marks)
            line = addMarkLegend(line);
        if (layer == MapLayer::Heights)
            grid_->addWidget(heights_ = new HeightControls(this), line++, 2, 1, 2);
        setLayer(layer, firstLayers()[i]);
    }
    grid_->setRowStretch(line, 1);
    connect(heights_, &HeightControls::lookChanged, this, [this] { tellEdit(layerName(MapLayer::Heights)); });
    told_ = saveState();
}

void LayersPanel::tellEdit(const QString& what) {
    if (restoring_)
        return;
    const QByteArray before = std::exchange(told_, saveState());
    emit edited(what, before, told_);
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
        tellEdit(layerName(layer));
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
    tellRange(row.opacity, tr("Opacity: %1 %").arg(row.opacity->value()), tr("10 %"), tr("100 %"));
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
    layers[look_key] = heights_->saveState();
    return QJsonDocument(layers).toJson(QJsonDocument::Compact);
}

bool LayersPanel::restoreState(const QByteArray& state) {
    const QJsonDocument document = QJsonDocument::fromJson(state);
    if (!document.isObject())
        return false;
    const QScopedValueRollback restoring(restoring_, true);
    for (std::size_t i = 0; i < map_layer_count; ++i) {
        const auto which = static_cast<MapLayer>(i);
        const LayerState before = layer(which);
        const QJsonObject saved = document.object()[layerName(which)].toObject();
        setLayer(which, {saved[visible_key].toBool(before.visible), saved[opacity_key].toDouble(before.opacity)});
        if (layer(which) != before)
            emit layerChanged(which, layer(which));
    }
    heights_->restoreState(document.object()[look_key].toObject());
    told_ = saveState();
    return true;
}

} // namespace usar::widgets
