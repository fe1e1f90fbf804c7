#include "widgets/models/campaign/run_table.h"

#include <cmath>
#include <limits>

#include "widgets/models/figures.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

QString figureText(const CampaignRun& run, std::size_t metric, const std::vector<CampaignMetric>& metrics) {
    const std::optional<double> value = metric < run.figures.size() ? run.figures[metric] : std::nullopt;
    const CampaignMetric& known = metrics[metric];
    const QString text = figure(value.value_or(std::nan("")), known.decimals);
    return value && !known.unit.isEmpty() ? text + ' ' + known.unit : text;
}

void RunTable::begin(const std::vector<CampaignMetric>& metrics) {
    beginResetModel();
    metrics_ = metrics;
    rows_.clear();
    endResetModel();
}

void RunTable::append(const std::vector<CampaignRun>& runs) {
    if (runs.empty())
        return;
    beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(runs.size()) - 1);
    rows_.insert(rows_.end(), runs.begin(), runs.end());
    endInsertRows();
}

int RunTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : reasonColumn() + 1;
}

QString RunTable::textOf(const CampaignRun& run, int column) const {
    switch (column) {
    case Number:
        return QString::number(run.number);
    case Variant:
        return run.variant;
    case Seed:
        return QString::number(run.seed);
    case Outcome:
        return run.differs ? tr("%1, not repeatable").arg(run.outcome) : run.outcome;
    default:
        return column == reasonColumn() ? run.reason
                                        : figureText(run, static_cast<std::size_t>(column - first_metric), metrics_);
    }
}

/// Unknown figures come last in ascending order.
QVariant RunTable::keyOf(const CampaignRun& run, int column) const {
    if (column == Number)
        return run.number;
    if (column == Seed)
        return run.seed;
    if (column < first_metric || column == reasonColumn())
        return textOf(run, column);
    const auto metric = static_cast<std::size_t>(column - first_metric);
    const auto value = metric < run.figures.size() ? run.figures[metric] : std::nullopt;
    return value.value_or(std::numeric_limits<double>::infinity());
}

QVariant RunTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const CampaignRun& run = row(index.row());
    const bool is_text = index.column() == Variant || index.column() == Outcome || index.column() == reasonColumn();
    switch (role) {
    case Qt::DisplayRole:
        return textOf(run, index.column());
    case Qt::ToolTipRole:
        return index.column() == reasonColumn() ? run.reason : index.column() == Variant ? run.variant : QVariant();
    case Qt::TextAlignmentRole:
        return static_cast<int>((is_text ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    case Qt::ForegroundRole:
        if (index.column() == Outcome && (!run.done || run.differs))
            return stateColor(run.outcome == "failed" ? StateShape::Waiting : StateShape::Bad);
        return {};
    case sort_role:
        return keyOf(run, index.column());
    default:
        return {};
    }
}

QVariant RunTable::headerData(int section, Qt::Orientation orientation, int role) const {
    const QString heads[] = {tr("Run"), tr("Variant"), tr("Seed"), tr("Outcome")};
    const bool is_text = section == Variant || section == Outcome || section == reasonColumn();
    const QString title = section < first_metric      ? heads[section]
                          : section == reasonColumn() ? tr("Reason")
                          : section < reasonColumn()  ? metrics_[static_cast<std::size_t>(section - first_metric)].title
                                                      : QString();
    return columnHead(orientation, role, title, is_text ? Qt::AlignLeft : Qt::AlignRight);
}

RunFilter::RunFilter(RunTable* table) : QSortFilterProxyModel(table), table_(*table) {
    setSourceModel(table);
    setSortRole(RunTable::sort_role);
}

void RunFilter::setWords(const QString& words) {
    words_ = words.simplified().split(' ', Qt::SkipEmptyParts);
    invalidateFilter();
}

void RunFilter::setOnlyFailures(bool on) {
    only_failures_ = on;
    invalidateFilter();
}

bool RunFilter::filterAcceptsRow(int row, const QModelIndex&) const {
    const CampaignRun& run = table_.row(row);
    if (only_failures_ && run.done && !run.differs)
        return false;
    const QString text = QStringLiteral("%1 %2 %3 %4 %5 %6")
                             .arg(run.number)
                             .arg(run.variant, run.mission)
                             .arg(run.seed)
                             .arg(run.outcome, run.reason);
    return std::ranges::all_of(words_, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

/// Equal ones stay in the order of their numbers.
bool RunFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    if (QSortFilterProxyModel::lessThan(left, right))
        return true;
    return !QSortFilterProxyModel::lessThan(right, left) &&
           table_.row(left.row()).number < table_.row(right.row()).number;
}

} // namespace usar::widgets
