#include "widgets/map/world_panel.h"

#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QDrag>
#include <QHeaderView>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QSignalBlocker>

#include "widgets/map/map_view.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int palette_columns = 4;
constexpr int object_icon_px = 24;

/// Without `suffix` the unit, meters, is written beside the box.
QuantityBox* makeBox(const QString& name, const QString& suffix, double lowest, double highest, QWidget* parent) {
    auto* box = new QuantityBox(parent);
    box->setAccessibleName(name);
    box->setRange(lowest, highest);
    box->setDecimals(2);
    box->setSingleStep(0.1);
    box->setSuffix(suffix);
    tellRange(box, name, QStringLiteral("m"));
    box->setMinimumWidth(56);
    return box;
}

QIcon colorIcon(protocol::TraceColor color) {
    QPixmap pixmap(16, 16);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0, 0, 0, 150), 1.0));
    painter.setBrush(widgets::traceColor(color));
    painter.drawEllipse(QPointF(8.0, 8.0), 6.0, 6.0);
    return pixmap;
}

/// Shows the button's word below its icon.
QToolButton* worded(QToolButton* button) {
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setFont(themeFont(FontRole::Small));
    button->setMinimumHeight(0); // Its own height is the least one, or a low dock would squeeze the word away.
    return button;
}

/// A button with the action's short word (QAction::iconText).
QToolButton* buttonFor(QAction* action, QWidget* parent) {
    auto* button = makeToolButton(action->toolTip(), parent);
    showAction(button, action);
    return worded(button);
}

} // namespace

MapObject PaletteChoice::object() const {
    MapObject object;
    object.name = object.kind = class_name;
    object.form = form;
    object.size_m = size_m;
    object.carries = conveyor;
    return object;
}

WorldPanel::WorldPanel(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("World"));
    buttons_->setExclusive(false); // A second click releases the button.
    palette_->setSpacing(gap::tiny);
    other_class_->setPlaceholderText(tr("Other class, e.g. USARModels.Pallet"));
    named(other_class_, tr("Other class"), tr("Type a class that only this server knows, then click on the map"));
    other_class_->setClearButtonEnabled(true);
    other_class_->setMinimumHeight(minimum_target);
    auto* column = laidOut(new QVBoxLayout(this), {gap::small, gap::small, gap::small, gap::small}, gap::tiny);
    column->addLayout(palette_);
    column->addWidget(other_class_);
    column->addLayout(makeSizeRow());
    makeList();
    column->addWidget(list_, 1);
    column->addLayout(object_row_);
    column->addLayout(makeWayRow());
    column->addLayout(makeTraceRow());
    trouble_ = new EmptyState(this);
    trouble_->hide();
    connect(other_class_, &QLineEdit::textChanged, this, [this](const QString& text) {
        if (!text.isEmpty())
            choose(-1);
        emit choiceChanged();
    });
}

QHBoxLayout* WorldPanel::makeSizeRow() {
    auto* row = laidOut(new QHBoxLayout, gap::tiny);
    row->addWidget(mutedLabel(tr("Size, m"), this));
    const QStringList names{tr("Length or diameter"), tr("Width"), tr("Height")};
    for (int axis = 0; axis < 3; ++axis) {
        size_m_[axis] = makeBox(names[axis], {}, 0.02, 50.0, this);
        size_m_[axis]->setValue(1.0);
        size_m_[axis]->setEnabled(false);
        row->addWidget(size_m_[axis], 1);
        connect(size_m_[axis], &QDoubleSpinBox::valueChanged, this, &WorldPanel::choiceChanged);
    }
    return row;
}

void WorldPanel::makeList() {
    list_->setModel(model_);
    list_->setAccessibleName(tr("Objects of the world"));
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAlternatingRowColors(true);
    list_->setMinimumHeight(72);
    QHeaderView* header = list_->header();
    header->setStretchLastSection(false);
    header->setSectionResizeMode(ObjectListModel::Name, QHeaderView::Stretch);
    header->setMinimumSectionSize(minimum_target);
    const QFontMetrics metrics(themeFont());
    const std::pair<int, QString> widths[] = {{ObjectListModel::Place, QStringLiteral("−000.0  −000.0")},
                                              {ObjectListModel::Speed, QStringLiteral("00.0")}};
    for (const auto& [section, sample] : widths)
        header->resizeSection(section, metrics.horizontalAdvance(sample) + gap::small);
    empty_list_ =
        new EmptyState(list_->viewport(), tr("No objects"), tr("Press a button above, then click on the map."));
    connect(addRowAction(list_, tr("Delete"), QKeySequence::Delete), &QAction::triggered, this, [this] {
        if (const QModelIndex current = list_->currentIndex(); current.isValid())
            emit removeRequested(model_->row(current.row()).name);
    });
    connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& current) {
        if (!quiet_)
            emit objectSelected(current.isValid() ? model_->row(current.row()).name : QString());
    });
}

QHBoxLayout* WorldPanel::makeWayRow() {
    speed_ = makeBox(tr("Speed along the waypoints, or of the belt"), tr(" m/s"), -5.0, 20.0, this);
    speed_->setValue(0.5);
    speed_->setButtonSymbols(QAbstractSpinBox::NoButtons); // They would cover the unit; keys and wheel do as well.
    speed_->setMinimumWidth(std::max(
        speed_->minimumWidth(), speed_->fontMetrics().horizontalAdvance(QStringLiteral("0.05 m/s")) + 2 * gap::small));
    loop_ = makeToolButton(tr("Starts over at the first waypoint after the last one"), this, QStringLiteral("reset"));
    loop_->setCheckable(true);
    worded(loop_)->setText(tr("Loop"));
    way_row_ = laidOut(new QHBoxLayout, gap::tiny, {speed_, loop_});
    way_row_->addStretch(1);
    return way_row_;
}

QHBoxLayout* WorldPanel::makeTraceRow() {
    trace_ = makeToolButton(tr("Trace"), this, QStringLiteral("trace"));
    trace_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    trace_color_ = named(new QComboBox(this), tr("Color of the trace"),
                         tr("Color of the marks that the selected robot leaves from now on"));
    for (const auto& [word, color] : protocol::wire_words<protocol::TraceColor>)
        trace_color_->addItem(colorIcon(color), QString::fromUtf8(word));
    auto* row = laidOut(new QHBoxLayout, gap::tiny, {trace_, trace_color_});
    row->addStretch(1);
    connect(trace_color_, &QComboBox::activated, this,
            [this](int index) { emit traceColorChosen(static_cast<protocol::TraceColor>(index)); });
    return row;
}

void WorldPanel::setKinds(const std::vector<PaletteKind>& kinds) {
    for (QAbstractButton* button : buttons_->buttons())
        delete button;
    kinds_ = kinds;
    chosen_ = nullptr;
    for (int i = 0; i < static_cast<int>(kinds.size()); ++i) {
        const PaletteKind& kind = kinds[static_cast<std::size_t>(i)];
        auto* button = makeToolButton(
            tr("%1, %2 × %3 × %4 m: press, then click on the map; or drag it there. Shift-click places several.")
                .arg(kind.class_name)
                .arg(kind.size_m.x())
                .arg(kind.size_m.y())
                .arg(kind.size_m.z()),
            this, kind.icon);
        button->setAccessibleName(kind.class_name);
        button->setText(kind.class_name);
        worded(button)->setIconSize({object_icon_px, object_icon_px});
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->installEventFilter(this);
        buttons_->addButton(button, i);
        palette_->addWidget(button, i / palette_columns, i % palette_columns);
        connect(button, &QToolButton::clicked, this, [this, i](bool down) { choose(down ? i : -1); });
    }
}

void WorldPanel::setActions(const std::vector<QAction*>& object, const std::vector<QAction*>& way, QAction* trace) {
    for (QAction* action : object)
        action ? object_row_->addWidget(buttonFor(action, this)) : object_row_->addStretch(1);
    object_row_->setSpacing(gap::tiny);
    for (QAction* action : way)
        action ? way_row_->addWidget(buttonFor(action, this)) : way_row_->addStretch(1);
    trace_->setDefaultAction(trace);
}

void WorldPanel::setObjects(const std::vector<MapObject>& objects) {
    const QModelIndex current = list_->currentIndex();
    const QString selected = current.isValid() ? model_->row(current.row()).name : QString();
    {
        const QScopedValueRollback quiet(quiet_, true);
        model_->setObjects(objects);
    }
    selectObject(selected);
    empty_list_->setVisible(objects.empty());
}

void WorldPanel::selectObject(const QString& name) {
    const QScopedValueRollback quiet(quiet_, true);
    const std::optional<int> row = model_->indexOf(name);
    list_->setCurrentIndex(row ? model_->index(*row, 0) : QModelIndex());
}

void WorldPanel::setTrouble(const QString& title, const QString& hint) {
    trouble_->setVisible(!title.isEmpty());
    trouble_->setText(title, hint);
    trouble_->raise();
    for (QWidget* child : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (child != trouble_)
            child->setVisible(title.isEmpty());
}

void WorldPanel::choose(int kind) {
    for (QAbstractButton* button : buttons_->buttons())
        button->setChecked(buttons_->id(button) == kind);
    chosen_ = kind < 0 ? nullptr : &kinds_[static_cast<std::size_t>(kind)];
    if (chosen_) {
        const QSignalBlocker quiet(other_class_);
        other_class_->clear();
        for (int axis = 0; axis < 3; ++axis) {
            const QSignalBlocker quiet_box(size_m_[axis]);
            size_m_[axis]->setValue(chosen_->size_m[axis]);
        }
    }
    size_m_[0]->setEnabled(chosen_);
    size_m_[1]->setEnabled(chosen_ && chosen_->form == ObjectForm::Box);
    size_m_[2]->setEnabled(chosen_ && chosen_->form != ObjectForm::Sphere);
    emit choiceChanged();
}

std::optional<PaletteChoice> WorldPanel::choice() const {
    const QString typed = other_class_->text().trimmed();
    if (!chosen_)
        return typed.isEmpty() ? std::nullopt : std::optional(PaletteChoice{{typed}});
    PaletteChoice choice{*chosen_};
    choice.size_m = {size_m_[0]->value(), size_m_[1]->value(), size_m_[2]->value()};
    if (choice.form != ObjectForm::Box)
        choice.size_m.y() = choice.size_m.x();
    if (choice.form == ObjectForm::Sphere)
        choice.size_m.z() = choice.size_m.x();
    choice.scale = choice.size_m.cwiseQuotient(chosen_->size_m);
    return choice;
}

void WorldPanel::disarm() {
    if (!choice())
        return;
    const QSignalBlocker quiet(other_class_);
    other_class_->clear();
    choose(-1);
}

bool WorldPanel::eventFilter(QObject* watched, QEvent* event) {
    auto* const button = qobject_cast<QToolButton*>(watched);
    if (!button || (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseMove))
        return QWidget::eventFilter(watched, event);
    const auto* const mouse = static_cast<QMouseEvent*>(event);
    if (event->type() == QEvent::MouseButtonPress) {
        pressed_at_ = mouse->pos();
    } else if (mouse->buttons() & Qt::LeftButton &&
               (mouse->pos() - pressed_at_).manhattanLength() >= QApplication::startDragDistance()) {
        drag(button);
        return true;
    }
    return false;
}

void WorldPanel::drag(QToolButton* button) {
    button->setDown(false);
    choose(buttons_->id(button));
    auto* const drag = new QDrag(this);
    auto* const mime = new QMimeData;
    mime->setData(object_mime, button->text().toUtf8());
    drag->setMimeData(mime);
    drag->setPixmap(button->icon().pixmap(object_icon_px, object_icon_px));
    drag->exec(Qt::CopyAction);
    disarm(); // Dropped on the map or elsewhere.
}

} // namespace usar::widgets
