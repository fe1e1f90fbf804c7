#include "widgets/messages/message_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QHeaderView>
#include <QLocale>
#include <QScopedValueRollback>
#include <QScrollBar>

#include "widgets/style/empty_state.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr int refresh_ms = 33;
constexpr int row_height_px = 22;
constexpr std::size_t most_rows_looked_at = 100;  ///< number of selected rows that are checked to enable actions
constexpr std::size_t most_rows_a_frame = 20'000; ///< limit after a pause; more would block the window

} // namespace

MessageList::MessageList(QWidget* parent) : QWidget(parent) {
    makeActions();
    bar_ = new MessageFilterBar(actions_.only_trouble, this);
    for (QAction* action : {actions_.pause, actions_.follow, actions_.details, actions_.clear})
        bar_->addButton(action);
    bar_->types()->setCounts([this] { return model_->types(); });
    laidOut(new QVBoxLayout(this), {}, 0, {bar_, splitter_})->setStretchFactor(splitter_, 1);
    splitter_->setChildrenCollapsible(false);
    splitter_->setStretchFactor(0, 3);
    splitter_->setStretchFactor(1, 2);
    detail_->setVisible(false);
    empty_state_ = new EmptyState(view_);
    empty_state_->setBackgroundRole(QPalette::Base);
    empty_state_->setAutoFillBackground(true);
    setUpView();
    wireView();
    wireActions();
    frame_.setSingleShot(true);
    frame_.setInterval(refresh_ms);
    connect(&frame_, &QTimer::timeout, this, &MessageList::flush);
    applyFilter();
    onThemeChange(this, [this] { view_->viewport()->update(); });
}

MessageList::~MessageList() {
    delete splitter_; // While the model still exists and can tell the view about removed rows.
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
    const int widths[] = {60, 72, 64, 52, 140};
    for (int column = 0; column < MessageModel::Text; ++column)
        header->resizeSection(column, std::max(widths[column], header->sectionSizeHint(column)));
}

void MessageList::wireView() {
    connect(view_->verticalScrollBar(), &QScrollBar::valueChanged, this, [this](int value) {
        if (!moving_)
            actions_.follow->setChecked(value >= view_->verticalScrollBar()->maximum());
    });
    connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] { noteSelection(); });
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &MessageList::enableActions);
    connect(view_, &QTableView::pressed, actions_.follow, [this] { actions_.follow->setChecked(false); });
    connect(view_, &QTableView::doubleClicked, actions_.details, [this] { actions_.details->setChecked(true); });
    connect(bar_, &MessageFilterBar::filterChanged, this, &MessageList::applyFilter);
    connect(model_, &MessageModel::filtered, this, [this] {
        keepPlace();
        updateState();
    });
    // A slice of the filter was inserted at the top: the visible rows keep their place.
    connect(model_, &MessageModel::rowsInserted, this, [this](const QModelIndex&, int first, int last) {
        if (!model_->filtering() || first > 0)
            return;
        const QScopedValueRollback moving(moving_, true);
        QScrollBar* scroll = view_->verticalScrollBar();
        if (actions_.follow->isChecked())
            view_->scrollToBottom();
        else
            scroll->setValue(scroll->value() + last - first + 1);
    });
    connect(detail_, &MessageDetail::jumpRequested, this, &MessageList::jumpTo);
    connect(saver_, &MessageSaver::saved, this, [this](const QString& path, int lines) {
        flushSoon();
        emit saved(path, lines);
    });
    connect(saver_, &MessageSaver::failed, this, &MessageList::failed);
}

void MessageList::takeLine(const protocol::InfoLine& line, Seconds time, ConnectionId connection) {
    keep(rowOf(line, time), connection);
}

void MessageList::takeCommand(std::string text, const Cause& cause, Seconds time, ConnectionId connection) {
    keep(rowOf(std::move(text), cause, ++commands_[connection], time), connection);
}

void MessageList::takeNotShown(std::uint64_t count, ConnectionId connection) {
    if (count == 0)
        return;
    if (!waiting_.empty() && waiting_.back().not_shown > 0 && waiting_.back().connection == connection) {
        count += waiting_.back().not_shown;
        waiting_.pop_back();
    }
    keep(gapOf(count), connection);
}

void MessageList::selectConnection(ConnectionId connection) {
    if (connection_ == connection)
        return;
    connection_ = connection;
    applyFilter();
}

void MessageList::keep(MessageRow row, ConnectionId connection) {
    row.connection = connection;
    waiting_bytes_ += row.text.size();
    waiting_.push_back(std::move(row));
    while (waiting_.size() > model_->capacity() || waiting_bytes_ > MessageModel::default_capacity_bytes) {
        overflown_ += std::max<std::uint64_t>(1, waiting_.front().not_shown);
        waiting_bytes_ -= std::min(waiting_bytes_, waiting_.front().text.size());
        waiting_.pop_front();
    }
    flushSoon();
}

void MessageList::flushSoon() {
    if (isVisible() && !frame_.isActive())
        frame_.start();
}

std::vector<MessageRow> MessageList::takeBatch() {
    const std::size_t count = std::min(waiting_.size(), most_rows_a_frame);
    const auto end = waiting_.begin() + static_cast<std::ptrdiff_t>(count);
    std::vector<MessageRow> batch(std::make_move_iterator(waiting_.begin()), std::make_move_iterator(end));
    waiting_.erase(waiting_.begin(), end);
    for (const MessageRow& row : batch)
        waiting_bytes_ -= std::min(waiting_bytes_, row.text.size());
    if (const std::uint64_t lost = std::exchange(overflown_, 0); lost > 0) {
        const ConnectionId connection = batch.front().connection;
        batch.front() = gapOf(lost + 1); // Replaces the oldest row, because the model is full.
        batch.front().connection = connection;
    }
    return batch;
}

void MessageList::flush() {
    if (!isVisible())
        return;
    if (!paused() && !saver_->busy() && !waiting_.empty()) {
        const QScopedValueRollback moving(moving_, true);
        QScrollBar* scroll = view_->verticalScrollBar();
        const int before = scroll->value();
        const int fallen = model_->append(takeBatch());
        if (actions_.follow->isChecked())
            view_->scrollToBottom();
        else if (fallen > 0)
            scroll->setValue(before - fallen);
        if (!waiting_.empty())
            flushSoon();
    }
    updateState();
}

void MessageList::applyFilter() {
    MessageFilter filter = bar_->filter();
    if (!actions_.all_robots->isChecked())
        filter.connection = connection_;
    view_->setColumnHidden(MessageModel::Robot, !actions_.all_robots->isChecked());
    {
        const QScopedValueRollback moving(moving_, true);
        model_->setFilter(filter);
    }
    keepPlace();
    updateState();
}

/// After a filter: scrolls to the end if the list follows it, else to the selected row if it is shown.
void MessageList::keepPlace() {
    const QScopedValueRollback moving(moving_, true);
    const int row = selected_ ? model_->shownRow(*selected_) : -1;
    if (row >= 0 && view_->currentIndex().row() != row)
        view_->selectRow(row);
    if (row >= 0 && !actions_.follow->isChecked())
        view_->scrollTo(model_->index(row, MessageModel::Type), QAbstractItemView::PositionAtCenter);
    else
        view_->scrollToBottom();
}

void MessageList::noteSelection() {
    const QModelIndex current = view_->currentIndex();
    if (!current.isValid())
        return; // Filtered out or removed: the details stay.
    selected_ = model_->serial(current.row());
    if (!detail_->isHidden())
        detail_->show(*model_, *selected_);
}

bool MessageList::jumpToLine(ConnectionId connection, LineNumber line) {
    const auto stored = [&] { return model_->serialOf(connection, Direction::In, line.value); };
    // Whoever asks for a line wants it at once, also while the list pauses.
    if (timeOf(connection, line)) {
        const QScopedValueRollback moving(moving_, true);
        while (!stored() && !waiting_.empty() && !saver_->busy())
            model_->append(takeBatch());
    }
    updateState();
    const auto serial = stored();
    if (serial)
        jumpTo(*serial);
    return serial.has_value();
}

std::optional<Seconds> MessageList::timeOf(ConnectionId connection, LineNumber line) const {
    const auto is_it = [&](const MessageRow& row) {
        return row.number == line.value && row.connection == connection && row.direction == Direction::In &&
               row.not_shown == 0;
    };
    const auto waiting = std::find_if(waiting_.rbegin(), waiting_.rend(), is_it);
    const auto stored = model_->serialOf(connection, Direction::In, line.value);
    const MessageRow* const row = waiting != waiting_.rend() ? &*waiting : stored ? model_->find(*stored) : nullptr;
    return row && std::isfinite(row->time.count()) ? std::optional(row->time) : std::nullopt;
}

void MessageList::jumpTo(std::uint64_t serial) {
    const MessageRow* target = model_->find(serial);
    if (!target)
        return;
    const ConnectionId connection = target->connection;
    actions_.follow->setChecked(false);
    selected_ = serial;
    if (model_->shownRow(serial) < 0) {
        if (connection != connection_)
            actions_.all_robots->setChecked(true);
        setFilter({});
        model_->finishFilter(); // Fast, because every row passes.
    }
    keepPlace();
    view_->setFocus();
}

void MessageList::clear() {
    waiting_.clear();
    waiting_bytes_ = 0;
    overflown_ = 0;
    model_->clear();
    selected_.reset();
    detail_->clearRow();
    actions_.follow->setChecked(true);
    updateState();
}

void MessageList::updateState() {
    const int shown = model_->rowCount();
    const int total = actions_.all_robots->isChecked() ? model_->total() : model_->totalOf(connection_);
    const QLocale words(QLocale::English);
    QString text = shown == total ? tr("%1 lines").arg(words.toString(total))
                                  : tr("%1 of %2 lines").arg(words.toString(shown), words.toString(total));
    if (model_->filtering())
        text += tr(", searching…");
    if (paused())
        text += tr(", %1 waiting").arg(words.toString(static_cast<qulonglong>(waiting_.size())));
    emit countChanged(text);
    if (total > 0)
        empty_state_->setText(tr("No matches"), tr("No message matches the filters."));
    else
        empty_state_->setText(tr("No messages yet"), tr("Every line from and to the server appears here."));
    empty_state_->setAction(total > 0 ? actions_.no_filter : nullptr);
    empty_state_->setVisible(shown == 0 && !model_->filtering());
    enableActions();
}

void MessageList::enableActions() {
    const int shown = model_->rowCount();
    const auto rows = selectedRows(most_rows_looked_at);
    const auto is_command = [](const MessageRow* row) { return row->direction == Direction::Out; };
    for (QAction* action :
         {actions_.copy, actions_.copy_text, actions_.copy_json, actions_.only_type, actions_.hide_type})
        action->setEnabled(!rows.empty());
    actions_.resend->setEnabled(std::ranges::any_of(rows, is_command));
    actions_.cause->setEnabled(rows.size() == 1 && rows.front()->trigger > 0);
    actions_.copy_shown->setEnabled(shown > 0);
    actions_.save->setEnabled(shown > 0 && !saver_->busy());
}

void MessageList::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    constexpr int wide_px = 760;
    constexpr int high_px = 300;
    // In a narrow list there would be no room for the text beside the details.
    const bool below = width() < wide_px && height() > high_px;
    splitter_->setOrientation(below ? Qt::Vertical : Qt::Horizontal);
}

void MessageList::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    flushSoon();
}

} // namespace usar::widgets
