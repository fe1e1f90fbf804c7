// The runs of a campaign as a table that is sorted and filtered.
#pragma once

#include <QSortFilterProxyModel>

#include "widgets/models/campaign/campaign_run.h"
#include "widgets/models/row_model.h"

namespace usar::widgets {

/// Rows are in the order in which the results came. Qt::UserRole gives what a column is sorted by. GUI thread.
class RunTable : public RowModel<CampaignRun, QAbstractTableModel> {
    Q_OBJECT
public:
    /// These columns come before those of the metrics; after them comes the reason.
    enum Column { Number, Variant, Seed, Outcome, first_metric };
    static constexpr int sort_role = Qt::UserRole;

    using RowModel::RowModel;

    /// Removes all runs; the next ones have these figures.
    void begin(const std::vector<CampaignMetric>& metrics);
    /// Adds runs below the others.
    void append(const std::vector<CampaignRun>& runs);
    const std::vector<CampaignRun>& runs() const { return rows_; }
    const std::vector<CampaignMetric>& metrics() const { return metrics_; }
    int reasonColumn() const { return first_metric + static_cast<int>(metrics_.size()); }

    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString textOf(const CampaignRun& run, int column) const;
    QVariant keyOf(const CampaignRun& run, int column) const;

    std::vector<CampaignMetric> metrics_;
};

/// Shows the runs that have all of the typed words somewhere in their row, and on request only those that were not
/// done. GUI thread.
class RunFilter : public QSortFilterProxyModel {
    Q_OBJECT
public:
    explicit RunFilter(RunTable* table);

    void setWords(const QString& words);
    void setOnlyFailures(bool on);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    const RunTable& table_;
    QStringList words_;
    bool only_failures_ = false;
};

} // namespace usar::widgets
