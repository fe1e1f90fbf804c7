#include "widgets/models/messages/message_model.h"

#include <algorithm>
#include <limits>

#include <QElapsedTimer>

#include "widgets/models/figures.h"
#include "widgets/models/messages/notification_model.h"
#include "widgets/models/row_model.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

// Part of a frame of 33 ms, because informing the view about the rows takes time as well.
constexpr qint64 slice_ms = 6;

std::size_t bytesOf(const MessageRow& row) {
    return sizeof(MessageRow) + row.type.capacity() + row.text.capacity() + row.note.capacity();
}

QString toolTipOf(const MessageRow& row) {
    constexpr std::size_t longest = 600;
    const QString text = QString::fromStdString(row.text.substr(0, longest)).toHtmlEscaped();
    const QString tail = row.text.size() > longest ? QStringLiteral(" …") : QString();
    if (row.note.empty())
        return QStringLiteral("<p>%1%2</p>").arg(text, tail);
    const QString note = QString::fromStdString(row.note).toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
    return QStringLiteral("<p><b>%1</b></p><p>%2%3</p>").arg(note, text, tail);
}

QColor inkOf(const MessageRow& row, int column) {
    const Tokens& t = tokens();
    if (row.trouble)
        return severityColor(*row.trouble);
    if (column == MessageModel::Number || column == MessageModel::Time || column == MessageModel::Robot)
        return t.text_muted;
    if (column == MessageModel::Type)
        return lineColor(familyOf(row), currentTheme());
    return row.direction == Direction::Out ? t.accent : t.text;
}

} // namespace

MessageModel::MessageModel(QObject* parent, std::size_t capacity, std::size_t capacity_bytes)
    : QAbstractTableModel(parent)
    , capacity_(capacity)
    , capacity_bytes_(capacity_bytes)
    , sieve_(std::make_unique<MessageSieve>(filter_)) {
    slice_.setInterval(0);
    connect(&slice_, &QTimer::timeout, this, [this] { filterOn(slice_ms); });
}

int MessageModel::append(std::vector<MessageRow> batch) {
    std::size_t drop = 0;
    trim(batch, drop);
    const int fallen = dropOldest(drop);
    std::vector<std::uint64_t> passing;
    for (std::size_t i = 0; i < batch.size(); ++i)
        if (sieve_->passes(batch[i]))
            passing.push_back(dropped_ + rows_.size() + i);
    if (!passing.empty())
        beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(passing.size()) - 1);
    for (MessageRow& row : batch) {
        bytes_ += bytesOf(row);
        tally(row, 1);
        rows_.push_back(std::move(row));
    }
    shown_.insert(shown_.end(), passing.begin(), passing.end());
    if (!passing.empty())
        endInsertRows();
    return fallen;
}

// Rows of the batch that would be removed at once are never stored.
void MessageModel::trim(std::vector<MessageRow>& batch, std::size_t& drop) const {
    std::size_t fresh_bytes = 0;
    std::size_t keep = 0;
    while (keep < std::min(batch.size(), capacity_)) {
        const std::size_t next = fresh_bytes + bytesOf(batch[batch.size() - 1 - keep]);
        if (next > capacity_bytes_)
            break;
        fresh_bytes = next;
        ++keep;
    }
    batch.erase(batch.begin(), batch.end() - static_cast<std::ptrdiff_t>(keep));
    std::size_t left_bytes = bytes_;
    while (drop < rows_.size() &&
           (rows_.size() - drop + keep > capacity_ || left_bytes + fresh_bytes > capacity_bytes_))
        left_bytes -= bytesOf(rows_[drop++]);
}

int MessageModel::dropOldest(std::size_t count) {
    const std::uint64_t first_kept = dropped_ + count;
    const auto end = std::ranges::lower_bound(shown_, first_kept);
    const int fallen = static_cast<int>(end - shown_.begin());
    if (fallen > 0)
        beginRemoveRows({}, 0, fallen - 1);
    for (std::size_t i = 0; i < count; ++i) {
        bytes_ -= bytesOf(rows_.front());
        tally(rows_.front(), -1);
        rows_.pop_front();
    }
    dropped_ = first_kept;
    unseen_ = std::max(unseen_, dropped_);
    shown_.erase(shown_.begin(), end);
    if (fallen > 0)
        endRemoveRows();
    return fallen;
}

void MessageModel::tally(const MessageRow& row, int more) {
    totals_[row.connection] += more;
    if (row.not_shown > 0)
        return;
    const auto type = types_.try_emplace(row.type, 0).first;
    if ((type->second += more) == 0)
        types_.erase(type);
}

int MessageModel::totalOf(ConnectionId connection) const {
    const auto found = totals_.find(connection);
    return found == totals_.end() ? 0 : found->second;
}

void MessageModel::clear() {
    beginResetModel();
    unseen_ = dropped_ += rows_.size();
    rows_.clear();
    shown_.clear();
    types_.clear();
    totals_.clear();
    bytes_ = 0;
    endResetModel();
}

void MessageModel::setFilter(const MessageFilter& filter) {
    if (filter == filter_)
        return;
    beginResetModel();
    filter_ = filter;
    sieve_ = std::make_unique<MessageSieve>(filter_);
    unseen_ = dropped_ + rows_.size();
    shown_ = sieveSlice(slice_ms);
    endResetModel();
    if (filtering())
        return slice_.start();
    slice_.stop();
    emit filtered();
}

void MessageModel::finishFilter() {
    if (filtering())
        filterOn(std::numeric_limits<qint64>::max());
}

void MessageModel::filterOn(qint64 budget_ms) {
    const std::deque<std::uint64_t> passing = sieveSlice(budget_ms);
    if (!passing.empty()) {
        beginInsertRows({}, 0, static_cast<int>(passing.size()) - 1);
        shown_.insert(shown_.begin(), passing.begin(), passing.end());
        endInsertRows();
    }
    if (filtering())
        return;
    slice_.stop();
    emit filtered();
}

std::deque<std::uint64_t> MessageModel::sieveSlice(qint64 budget_ms) {
    constexpr std::uint64_t rows_a_look = 256; // Between two readings of the clock.
    std::deque<std::uint64_t> passing;
    QElapsedTimer timer;
    timer.start();
    while (filtering() && (unseen_ % rows_a_look != 0 || timer.elapsed() < budget_ms)) {
        --unseen_;
        if (sieve_->passes(rows_[unseen_ - dropped_]))
            passing.push_front(unseen_);
    }
    return passing;
}

void MessageModel::nameConnection(ConnectionId connection, const QString& name) {
    if (QString& known = names_[connection]; known != name) {
        known = name;
        if (rowCount() > 0)
            emit dataChanged(index(0, Robot), index(rowCount() - 1, Robot));
    }
}

QString MessageModel::connectionName(ConnectionId connection) const {
    const auto found = names_.find(connection);
    return found == names_.end() ? QString() : found->second;
}

int MessageModel::shownRow(std::uint64_t serial) const {
    const auto found = std::ranges::lower_bound(shown_, serial);
    return found == shown_.end() || *found != serial ? -1 : static_cast<int>(found - shown_.begin());
}

const MessageRow* MessageModel::find(std::uint64_t serial) const {
    return serial < dropped_ || serial >= dropped_ + rows_.size() ? nullptr : &rows_[serial - dropped_];
}

std::optional<std::uint64_t> MessageModel::serialOf(ConnectionId connection, Direction direction,
                                                    std::uint64_t number) const {
    for (std::size_t i = rows_.size(); i > 0; --i) {
        const MessageRow& row = rows_[i - 1];
        if (row.number == number && row.connection == connection && row.direction == direction && row.not_shown == 0)
            return dropped_ + i - 1;
    }
    return std::nullopt;
}

std::vector<std::uint64_t> MessageModel::causedBy(std::uint64_t serial) const {
    constexpr std::size_t few = 5;
    constexpr std::size_t reach = 2000; // An answer follows soon.
    std::vector<std::uint64_t> caused;
    const MessageRow* cause = find(serial);
    if (!cause || cause->direction != Direction::In || cause->not_shown > 0)
        return caused;
    const std::size_t from = serial - dropped_;
    for (std::size_t i = from + 1; i < std::min(rows_.size(), from + reach) && caused.size() < few; ++i)
        if (rows_[i].trigger == cause->number && rows_[i].connection == cause->connection)
            caused.push_back(dropped_ + i);
    return caused;
}

int MessageModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(shown_.size());
}

QVariant MessageModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const MessageRow& message = row(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return shownText(message, index.column());
    case Qt::ToolTipRole:
        return toolTipOf(message);
    case Qt::ForegroundRole:
        return inkOf(message, index.column());
    case Qt::DecorationRole:
        if (index.column() == Type && message.trouble)
            return icon(QStringLiteral("warning"), inkOf(message, Text));
        return {};
    case Qt::TextAlignmentRole:
        return headerData(index.column(), Qt::Horizontal, role);
    default:
        return {};
    }
}

QVariant MessageModel::shownText(const MessageRow& row, int column) const {
    constexpr std::size_t longest = 400; // No window shows more of a line.
    if (row.not_shown > 0 && column < Type && column != Robot)
        return {};
    switch (column) {
    case Robot:
        return connectionName(row.connection);
    case Number:
        return QString::number(row.number);
    case Time:
        return figure(row.time.count(), 2);
    case Way:
        return row.direction == Direction::In ? tr("← in") : tr("→ out");
    case Type:
        return QString::fromStdString(row.type);
    default:
        return QString::fromStdString(row.text.size() > longest ? row.text.substr(0, longest) : row.text);
    }
}

QVariant MessageModel::headerData(int section, Qt::Orientation orientation, int role) const {
    const QString names[] = {tr("No."), tr("Time, s"), tr("Robot"), tr("Direction"), tr("Type"), tr("Text")};
    return columnHead(orientation, role, names[section], section <= Time ? Qt::AlignRight : Qt::AlignLeft);
}

} // namespace usar::widgets
