// List of how well robots and base stations hear each other: one row per pair.
#pragma once

#include "widgets/models/radio_links.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

class EmptyState;

/// State comes in by setters; the view requests nothing. A line below the list explains bars and dashes and names the
/// source of the measurements. GUI thread.
class RadioView : public QWidget {
    Q_OBJECT
public:
    explicit RadioView(QWidget* parent = nullptr);

    /// Replaces all links; each call adds one sample to the histories.
    void take(const std::vector<RadioLink>& links);
    /// Name of the measuring server: "Wireless server at 127.0.0.1:50000".
    void setSource(const QString& source);
    const RadioLinkModel& model() const { return *model_; }
    /// Says what is missing while there are no pairs. `radios`: how many there are; `trouble`: why the wireless server
    /// does not answer, or empty; `remedy`: puts up one more radio, and is offered while there are less than two.
    void explainEmptiness(qsizetype radios, const QString& trouble, QAction* remedy);
    EmptyState* emptyState() const { return empty_state_; }
    QSize sizeHint() const override { return {400, 200}; }
    QSize minimumSizeHint() const override { return {240, 100}; }

private:
    RadioLinkModel* model_ = new RadioLinkModel(this);
    QListView* view_ = new QListView(this);
    QLabel* legend_ = mutedLabel({}, this);
    EmptyState* empty_state_;
};

} // namespace usar::widgets
