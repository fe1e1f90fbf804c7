#include "widgets/message_list.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QScrollBar>
#include <QVBoxLayout>

#include "widgets/empty_state.h"
#include "widgets/theme.h"
#include "widgets/tool_button.h"

namespace usar::widgets {

namespace {
constexpr int frame_ms = 33;
constexpr int row_height_px = 22;
} // namespace

MessageList::MessageList(QWidget* parent)
    : QWidget(parent)
    , model_(new MessageModel(this))
    , view_(new QTableView(this))
    , search_(makeSearchLine(tr("Search type or text"), tr("Shows only lines whose type or text contains this"), this))
    , way_(new QComboBox(this))
    , count_(new QLabel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeTools());
    column->addWidget(view_, 1);
    setUpView();
    setUpActions();
    empty_state_ = new EmptyState(view_);
    empty_state_->setBackgroundRole(QPalette::Base);
    empty_state_->setAutoFillBackground(true);
    frame_.setSingleShot(true);
    frame_.setInterval(frame_ms);
    connect(&frame_, &QTimer::timeout, this, &MessageList::flush);
    updateState();
}

QWidget* MessageList::makeTools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(gap::tiny, gap::tiny, gap::tiny, gap::tiny);
    row->setSpacing(gap::tiny);
    way_->addItems({tr("In and out"), tr("← in"), tr("→ out")});
    way_->setToolTip(tr("What came from the server, what was sent, or both"));
    way_->setAccessibleName(way_->toolTip());
    way_->setMinimumHeight(minimum_target);
    pause_ = makeToolButton(tr("Hold the list still; lines are kept and come later"), tools, "pause");
    pause_->setCheckable(true);
    auto* clear_button = makeToolButton(tr("Take all lines away"), tools, "clear");
    count_->setProperty("role", "muted");
    count_->setObjectName(QStringLiteral("count"));
    row->addWidget(search_, 1);
    row->addWidget(way_);
    row->addWidget(pause_);
    row->addWidget(clear_button);
    row->addWidget(count_);
    connect(search_, &QLineEdit::textChanged, this, &MessageList::applyFilter);
    connect(way_, &QComboBox::currentIndexChanged, this, &MessageList::applyFilter);
    connect(pause_, &QToolButton::toggled, this, &MessageList::flushSoon);
    connect(pause_, &QToolButton::toggled, this, &MessageList::updateState);
    connect(clear_button, &QToolButton::clicked, this, &MessageList::clear);
    return tools;
}

void MessageList::setUpView() {
    view_->setModel(model_);
    view_->setFrameShape(QFrame::NoFrame);
    view_->setShowGrid(false);
    view_->setWordWrap(false);
    view_->setFont(codeFont());
    view_->setTabKeyNavigation(false);
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    view_->setAccessibleName(tr("Messages"));
    view_->verticalHeader()->hide();
    view_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    view_->verticalHeader()->setMinimumSectionSize(row_height_px);
    view_->verticalHeader()->setDefaultSectionSize(row_height_px);
    QHeaderView* header = view_->horizontalHeader();
    header->setHighlightSections(false);
    header->setStretchLastSection(true);
    const int widths[] = {68, 80, 60, 150};
    for (int column = 0; column < MessageModel::Text; ++column)
        header->resizeSection(column, widths[column]);
}

void MessageList::setUpActions() {
    view_->setContextMenuPolicy(Qt::ActionsContextMenu);
    auto* copy = new QAction(tr("Copy"), view_);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    auto* copy_text = new QAction(tr("Copy text only"), view_);
    auto* alike = new QAction(tr("Show only this type"), view_);
    view_->addActions({copy, copy_text, alike});
    connect(copy, &QAction::triggered, this, [this] { copySelected(false); });
    connect(copy_text, &QAction::triggered, this, [this] { copySelected(true); });
    connect(alike, &QAction::triggered, this, &MessageList::filterLikeCurrent);
}

void MessageList::takeLine(const protocol::InfoLine& line, Seconds time) {
    keep(rowOf(line, time));
}

void MessageList::takeCommand(const agent::CausedCommand& command, Seconds time, protocol::Dialect dialect) {
    keep(rowOf(command, ++commands_, time, dialect));
}

void MessageList::takeNotShown(std::uint64_t count) {
    if (count == 0)
        return;
    if (!waiting_.empty() && waiting_.back().not_shown > 0) {
        count += waiting_.back().not_shown;
        waiting_.pop_back();
    }
    keep(gapOf(count));
}

void MessageList::keep(MessageRow row) {
    waiting_.push_back(std::move(row));
    if (waiting_.size() > model_->capacity()) {
        overflown_ += std::max<std::uint64_t>(1, waiting_.front().not_shown);
        waiting_.pop_front();
    }
    flushSoon();
}

void MessageList::flushSoon() {
    if (isVisible() && !frame_.isActive())
        frame_.start();
}

void MessageList::flush() {
    if (!isVisible())
        return;
    if (!paused() && !waiting_.empty()) {
        QScrollBar* bar = view_->verticalScrollBar();
        const bool at_end = bar->value() >= bar->maximum();
        std::vector<MessageRow> batch(std::make_move_iterator(waiting_.begin()),
                                      std::make_move_iterator(waiting_.end()));
        waiting_.clear();
        if (const std::uint64_t lost = std::exchange(overflown_, 0); lost > 0)
            batch.front() = gapOf(lost + 1); // in the place of the oldest, for the model is full
        const int before = bar->value();
        const int fallen = model_->append(std::move(batch));
        if (at_end)
            view_->scrollToBottom();
        else if (fallen > 0)
            bar->setValue(before - fallen);
    }
    updateState();
}

void MessageList::setFilter(const MessageFilter& filter) {
    search_->setText(filter.words);
    way_->setCurrentIndex(!filter.direction ? 0 : *filter.direction == Direction::In ? 1 : 2);
}

void MessageList::applyFilter() {
    MessageFilter filter;
    filter.words = search_->text().trimmed();
    if (way_->currentIndex() > 0)
        filter.direction = way_->currentIndex() == 1 ? Direction::In : Direction::Out;
    model_->setFilter(filter);
    view_->scrollToBottom();
    updateState();
}

void MessageList::setPaused(bool paused) {
    pause_->setChecked(paused);
}

void MessageList::clear() {
    waiting_.clear();
    overflown_ = 0;
    model_->clear();
    updateState();
}

void MessageList::copySelected(bool text_only) {
    QStringList lines;
    for (const QModelIndex& index : view_->selectionModel()->selectedRows()) {
        const MessageRow& row = model_->row(index.row());
        QStringList cells;
        for (int column = 0; column < MessageModel::Text && !text_only; ++column)
            cells << index.siblingAtColumn(column).data().toString();
        cells << QString::fromStdString(row.text);
        lines << cells.join(u'\t');
    }
    QGuiApplication::clipboard()->setText(lines.join(u'\n'));
}

void MessageList::filterLikeCurrent() {
    if (const QModelIndex current = view_->currentIndex(); current.isValid())
        search_->setText(QString::fromStdString(model_->row(current.row()).type));
}

void MessageList::updateState() {
    const int shown = model_->rowCount();
    const int total = model_->total();
    QString text = shown == total ? QString::number(total) : tr("%1 of %2").arg(shown).arg(total);
    if (paused())
        text += tr(", %1 waiting").arg(waiting_.size());
    count_->setText(text);
    if (total > 0)
        empty_state_->setText(tr("No line fits"), tr("Nothing of the traffic fits search and direction."));
    else
        empty_state_->setText(tr("No messages yet"), tr("Every line from and to the server appears here."));
    empty_state_->setVisible(shown == 0);
}

void MessageList::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    flushSoon();
}

void MessageList::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && view_)
        view_->viewport()->update();
    QWidget::changeEvent(event);
}

} // namespace usar::widgets
