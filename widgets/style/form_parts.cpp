#include "widgets/style/form_parts.h"

#include <utility>

#include <QMenu>
#include <QPainter>
#include <QStyle>

#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

class ThemeWatch : public QObject {
public:
    ThemeWatch(QWidget* widget, std::function<void()> repaint, QEvent::Type when)
        : QObject(widget)
        , repaint_(std::move(repaint))
        , when_(when) {
        widget->installEventFilter(this);
    }

    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == when_)
            repaint_();
        return false;
    }

private:
    std::function<void()> repaint_;
    QEvent::Type when_;
};

} // namespace

QGridLayout* gridOf(QWidget* parent, const QMargins& margins, int column_gap, int row_gap) {
    auto* grid = new QGridLayout(parent);
    grid->setContentsMargins(margins);
    grid->setHorizontalSpacing(column_gap);
    grid->setVerticalSpacing(row_gap);
    return grid;
}

QPushButton* makeStopButton(const QString& text, const QString& help, QWidget* parent) {
    auto* button = new QPushButton(icon(QStringLiteral("stop"), tokens().on_fill), text, parent);
    button->setProperty("role", "stop");
    button->setToolTip(help);
    return button;
}

QLabel* mutedLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("role", "muted");
    return label;
}

void setRole(QWidget* widget, const char* role) {
    if (widget->property("role").toByteArray() == role)
        return;
    widget->setProperty("role", role);
    widget->style()->unpolish(widget); // Otherwise the color of the previous role would stay.
    widget->style()->polish(widget);
}

void makeFlat(QToolButton* button) {
    button->setAutoRaise(true);
    button->setMinimumSize(minimum_target, minimum_target);
}

void showAction(QToolButton* button, QAction* action) {
    button->setDefaultAction(action);
    button->setAccessibleName(action->text());
}

void followAction(QPushButton* button, QAction* action) {
    const auto follow = [button, action] {
        button->setEnabled(action->isEnabled());
        button->setToolTip(action->toolTip());
    };
    QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
    QObject::connect(action, &QAction::changed, button, follow);
    follow();
}

QPointF arrowDirection(int key) {
    const int right = (key == Qt::Key_Right) - (key == Qt::Key_Left);
    const int up = (key == Qt::Key_Up) - (key == Qt::Key_Down);
    return QPointF(right, up);
}

QAction* addRowAction(QAbstractItemView* view, const QString& text, const QKeySequence& keys) {
    auto* action = new QAction(text, view);
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    view->addAction(action);
    return action;
}

void popUpRowMenu(QAbstractItemView* view, const QPoint& at) {
    if (!view->indexAt(at).isValid())
        return;
    auto* menu = new QMenu(view);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions(view->actions());
    menu->popup(view->viewport()->mapToGlobal(at));
}

void setUpPaintedRows(QListView* view, QAbstractItemModel* model, QAbstractItemDelegate* delegate,
                      const QString& name) {
    view->setModel(model);
    view->setItemDelegate(delegate);
    view->setFrameShape(QFrame::NoFrame);
    view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view->setAccessibleName(name);
    view->parentWidget()->setFocusProxy(view);
}

void onThemeChange(QWidget* widget, std::function<void()> repaint, QEvent::Type when) {
    new ThemeWatch(widget, std::move(repaint), when);
}

QString fittedText(const QString& text, const QFontMetrics& metrics, int width_px) {
    QString shown = text;
    for (auto part = shown.lastIndexOf(u" · "); part > 0 && metrics.horizontalAdvance(shown) > width_px;
         part = shown.lastIndexOf(u" · "))
        shown.truncate(part);
    return metrics.elidedText(shown, Qt::ElideRight, width_px);
}

QSize ElidedLabel::sizeHint() const {
    const QSize hint = QLabel::sizeHint();
    return room_for_.isEmpty() ? hint : QSize(fontMetrics().horizontalAdvance(room_for_), hint.height());
}

void ElidedLabel::setRoomFor(const QString& text) {
    if (std::exchange(room_for_, text) == text)
        return;
    updateGeometry();
}

void ElidedLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
    const QRect room = contentsRect();
    painter.drawText(room, static_cast<int>(alignment() | Qt::TextSingleLine),
                     fittedText(text(), fontMetrics(), room.width()));
}

StateDot::StateDot(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void StateDot::setState(StateShape state) {
    state_ = state;
    update();
}

QColor stateColor(StateShape state) {
    const Tokens& t = tokens();
    const QColor colors[] = {t.text_muted, t.accent, t.ok, t.caution, t.danger};
    return colors[static_cast<std::size_t>(state)];
}

const char* stateRole(StateShape state) {
    constexpr const char* roles[] = {"muted", "accent", "ok", "caution", "danger"};
    return roles[static_cast<std::size_t>(state)];
}

void StateDot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(width() / 2.0, height() / 2.0);
    const QColor color = stateColor(state_);
    const QRectF circle(-5.0, -5.0, 10.0, 10.0);
    painter.setPen(QPen(color, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (state_ == StateShape::Good)
        painter.setBrush(color);
    if (state_ == StateShape::Waiting)
        painter.drawPolygon(QPolygonF({{0.0, -5.5}, {6.0, 5.0}, {-6.0, 5.0}}));
    else
        painter.drawEllipse(circle);
    if (state_ == StateShape::Busy) {
        painter.setBrush(color);
        painter.drawChord(circle, 90 * 16, 180 * 16);
    } else if (state_ == StateShape::Bad) {
        painter.drawLine(QPointF(-2.0, -2.0), QPointF(2.0, 2.0));
        painter.drawLine(QPointF(2.0, -2.0), QPointF(-2.0, 2.0));
    }
}

} // namespace usar::widgets
