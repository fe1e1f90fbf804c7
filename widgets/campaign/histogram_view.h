// Histograms of one figure of a campaign's runs, a color for each variant.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "widgets/models/campaign/run_histogram.h"
#include "widgets/models/campaign/run_table.h"

class QCustomPlot;

namespace usar::widgets {

class EmptyState;

/// Follows a table of runs, several times a second at most. A hidden view does no work. GUI thread.
class HistogramView : public QWidget {
    Q_OBJECT
public:
    /// The table must outlive the view.
    explicit HistogramView(const RunTable& table, QWidget* parent = nullptr);
    ~HistogramView() override;

    const RunHistogram& histogram() const { return histogram_; }
    QSize sizeHint() const override { return {400, 220}; }
    QSize minimumSizeHint() const override { return {220, 140}; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void listMetrics();
    /// Counts and draws soon, once for all runs that come until then.
    void drawSoon();
    void draw();
    void drawBars();
    /// Names the variants with their colors, and says how many runs have no such figure.
    void writeLegend();

    const RunTable& table_;
    RunHistogram histogram_;
    QComboBox* metric_ = new QComboBox(this);
    QLabel* legend_ = new QLabel(this);
    QCustomPlot* plot_;
    EmptyState* nothing_;
    bool due_ = false; ///< `draw` is on its way.
};

} // namespace usar::widgets
