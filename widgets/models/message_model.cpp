#include "widgets/models/message_model.h"

#include <algorithm>

#include "widgets/icons.h"
#include "widgets/models/caseless_finder.h"
#include "widgets/models/figures.h"
#include "widgets/theme.h"

namespace usar::widgets {

namespace {

std::size_t bytesOf(const MessageRow& row) {
    return sizeof(MessageRow) + row.type.capacity() + row.text.capacity() + row.note.capacity();
}

class Sieve {
public:
    explicit Sieve(const MessageFilter& filter) : finder_(filter.words.toStdString()), direction_(filter.direction) {}
    bool passes(const MessageRow& row) const {
        if (row.not_shown > 0)
            return true; // what is left out is said, whatever is searched
        return (!direction_ || *direction_ == row.direction) && (finder_.isIn(row.type) || finder_.isIn(row.text));
    }

private:
    CaselessFinder finder_;
    std::optional<Direction> direction_;
};

QString toolTipOf(const MessageRow& row) {
    constexpr std::size_t longest = 600;
    const QString text = QString::fromStdString(row.text.substr(0, longest)).toHtmlEscaped();
    const QString tail = row.text.size() > longest ? QStringLiteral(" …") : QString();
    if (row.note.empty())
        return QStringLiteral("<p>%1%2</p>").arg(text, tail);
    const QString note = QString::fromStdString(row.note).toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
    return QStringLiteral("<p><b>%1</b></p><p>%2%3</p>").arg(note, text, tail);
}

} // namespace

MessageModel::MessageModel(QObject* parent, std::size_t capacity, std::size_t capacity_bytes)
    : QAbstractTableModel(parent)
    , capacity_(capacity)
    , capacity_bytes_(capacity_bytes) {}

int MessageModel::append(std::vector<MessageRow> batch) {
    std::size_t drop = 0;
    trim(batch, drop);
    const int fallen = dropOldest(drop);
    const Sieve sieve(filter_);
    std::vector<std::uint64_t> passing;
    for (std::size_t i = 0; i < batch.size(); ++i)
        if (sieve.passes(batch[i]))
            passing.push_back(dropped_ + rows_.size() + i);
    if (!passing.empty())
        beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(passing.size()) - 1);
    for (MessageRow& row : batch) {
        bytes_ += bytesOf(row);
        rows_.push_back(std::move(row));
    }
    shown_.insert(shown_.end(), passing.begin(), passing.end());
    if (!passing.empty())
        endInsertRows();
    return fallen;
}

// What of the batch would fall out again at once is never taken in.
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
        rows_.pop_front();
    }
    dropped_ = first_kept;
    shown_.erase(shown_.begin(), end);
    if (fallen > 0)
        endRemoveRows();
    return fallen;
}

void MessageModel::clear() {
    beginResetModel();
    dropped_ += rows_.size();
    rows_.clear();
    shown_.clear();
    bytes_ = 0;
    endResetModel();
}

void MessageModel::setFilter(const MessageFilter& filter) {
    if (filter == filter_)
        return;
    beginResetModel();
    filter_ = filter;
    shown_.clear();
    const Sieve sieve(filter_);
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (sieve.passes(rows_[i]))
            shown_.push_back(dropped_ + i);
    endResetModel();
}

const MessageRow& MessageModel::row(int shown) const {
    return rows_[shown_[static_cast<std::size_t>(shown)] - dropped_];
}

int MessageModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(shown_.size());
}

int MessageModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : column_count;
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
        return ink(message, index.column());
    case Qt::DecorationRole:
        if (index.column() == Type && message.trouble)
            return icon(QStringLiteral("warning"), ink(message, Text).value<QColor>());
        return {};
    case Qt::TextAlignmentRole:
        if (index.column() == Number || index.column() == Time)
            return QVariant(Qt::AlignRight | Qt::AlignVCenter);
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    default:
        return {};
    }
}

QVariant MessageModel::shownText(const MessageRow& row, int column) const {
    constexpr std::size_t longest = 400; // no window shows more of one line
    if (row.not_shown > 0 && column < Type)
        return {};
    switch (column) {
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

QVariant MessageModel::ink(const MessageRow& row, int column) const {
    const Tokens& t = tokens();
    if (row.trouble)
        return *row.trouble == Severity::Error ? t.danger : *row.trouble == Severity::Warning ? t.caution : t.accent;
    if (column == Number || column == Time)
        return t.text_muted;
    return row.direction == Direction::Out ? t.accent : t.text;
}

QVariant MessageModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant((section <= Time ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString names[] = {tr("No."), tr("Time, s"), tr("Way"), tr("Type"), tr("Text")};
    return names[section];
}

} // namespace usar::widgets
