// How well robots and base stations hear each other: one row a pair, weakest to be seen at a glance.
#pragma once

#include <QLabel>
#include <QListView>
#include <QWidget>

#include "widgets/models/radio_links.h"

namespace usar::widgets {

class EmptyState;

/// Values in by setters; it asks nobody. Under the list a line says what bars and dashes mean and who measured. GUI
/// thread.
class RadioView : public QWidget {
    Q_OBJECT
public:
    explicit RadioView(QWidget* parent = nullptr);

    void take(const std::vector<RadioLink>& links);
    /// "Wireless server at 127.0.0.1:50000": who measured.
    void setSource(const QString& source);
    const RadioLinkModel& model() const { return *model_; }
    /// Shown while there is no pair: whoever knows why fills it.
    EmptyState* emptyState() const { return empty_state_; }
    QSize sizeHint() const override { return {400, 200}; }
    QSize minimumSizeHint() const override { return {240, 100}; }

private:
    RadioLinkModel* model_;
    QListView* view_;
    QLabel* legend_;
    EmptyState* empty_state_;
};

} // namespace usar::widgets
