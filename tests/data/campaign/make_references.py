#!/usr/bin/env python3
"""Writes references.json beside itself: what scipy says of some samples.

The tests of core/campaign/statistics read the file, so that they need no scipy. Run this again after a change here, with
Debian 12's python3-scipy (1.10.1).
"""
import json
import pathlib

import numpy as np
import scipy
from scipy import stats

random = np.random.default_rng(22)


def numbers(values, decimals=3):
    return [round(float(v), decimals) for v in values]


def proportion(successes, trials, confidence):
    test = stats.binomtest(successes, trials)
    at_most = stats.binomtest(successes, trials, alternative="less").proportion_ci(confidence, "exact")
    at_least = stats.binomtest(successes, trials, alternative="greater").proportion_ci(confidence, "exact")
    return {
        "successes": successes, "trials": trials, "confidence": confidence,
        "wilson": list(test.proportion_ci(confidence, "wilson")),
        "clopper_pearson": list(test.proportion_ci(confidence, "exact")),
        "highest": at_most.high, "lowest": at_least.low,
    }


def mcnemar(baseline_only, candidate_only):
    p = stats.binomtest(baseline_only, baseline_only + candidate_only).pvalue
    return {"baseline_only": baseline_only, "candidate_only": candidate_only, "p": p}


def wilcoxon(name, differences):
    # scipy calls a sample with equal sizes exact as well, and is wrong there, so the way is chosen here.
    ranked = np.abs([d for d in differences if d != 0])
    exact = len(ranked) <= 50 and len(set(ranked)) == len(ranked)
    ranked_ones = [d for d in differences if d != 0]
    p = stats.wilcoxon(ranked_ones, method="exact" if exact else "approx").pvalue
    return {"name": name, "differences": differences, "p": p}


def pairs(name, baseline, candidate):
    difference = np.subtract(candidate, baseline)
    return {
        "name": name, "baseline": baseline, "candidate": candidate,
        "correlation": stats.pearsonr(baseline, candidate)[0],
        "variance_ratio": np.var(difference, ddof=1) / (np.var(baseline, ddof=1) + np.var(candidate, ddof=1)),
        "geometric_mean": stats.gmean(np.divide(candidate, baseline)),
        "median": np.median(difference),
        "interquartile_mean": stats.trim_mean(difference, 0.25),
        "tenth": np.quantile(difference, 0.1),
    }


def bootstrap(name, groups, share):
    """Percentiles of many resamples; with several groups each is drawn for itself."""
    def estimate(*samples, axis=-1):
        return stats.trim_mean(np.concatenate(samples, axis=axis), share, axis=axis)

    result = stats.bootstrap(groups, estimate, n_resamples=100_000, method="BCa", vectorized=True, batch=2_000,
                             random_state=np.random.default_rng(1))
    interval = result.confidence_interval
    return {"name": name, "groups": [list(g) for g in groups], "trimmed_share": share,
            "low": interval.low, "high": interval.high}


def lognormal(size, decimals=3):
    return numbers(random.lognormal(0.0, 0.8, size), decimals)


baseline = numbers(random.normal(60.0, 8.0, 25))
references = {
    "scipy": scipy.__version__,
    "proportions": [proportion(*c) for c in [
        (0, 200, 0.95), (0, 1000, 0.95), (45, 50, 0.95), (50, 50, 0.95), (1, 3, 0.9), (7, 13, 0.99), (4321, 9999, 0.95)]],
    "mcnemar": [mcnemar(*c) for c in [(0, 5), (1, 9), (12, 3), (7, 7), (40, 61), (300, 240)]],
    "wilcoxon": [
        wilcoxon("five of one sign", [1.0, 2.0, 3.0, 4.0, 5.0]),
        wilcoxon("exact", numbers(random.normal(0.4, 1.0, 17))),
        wilcoxon("exact with zeros", numbers(random.normal(0.3, 1.0, 20)) + [0.0, 0.0, 0.0]),
        wilcoxon("the largest exact one", numbers(random.normal(0.3, 1.0, 50), 6)),
        wilcoxon("the smallest approximated one", numbers(random.normal(0.3, 1.0, 51), 6)),
        wilcoxon("few with equal sizes", [1.0, -1.0, 2.0, 2.0, 3.0, -2.0, 1.0, 4.0, 4.0, 0.0]),
        wilcoxon("many with equal sizes", numbers(random.integers(-2, 5, 120), 0)),
    ],
    "holm": [{"p": p, "adjusted": a} for p, a in [
        # By hand from the definition, as scipy has no Holm.
        ([0.01, 0.04, 0.03], [0.03, 0.06, 0.06]), ([0.5], [0.5]), ([0.9, 0.8, 0.001], [1.0, 1.0, 0.003])]],
    "pairs": [
        pairs("alike by seed", baseline, numbers(np.add(baseline, random.normal(-2.0, 2.0, 25)))),
        pairs("not alike", baseline, numbers(random.normal(55.0, 8.0, 25))),
    ],
    "bootstrap": [
        bootstrap("skewed mean", (lognormal(30),), 0.0),
        bootstrap("skewed interquartile mean", (lognormal(41),), 0.25),
        bootstrap("two groups of unlike size and level", (lognormal(12), numbers(random.normal(5.0, 2.0, 30))), 0.25),
        bootstrap("mean of two groups", (lognormal(9), numbers(random.normal(5.0, 0.5, 25))), 0.0),
    ],
}

path = pathlib.Path(__file__).with_name("references.json")
path.write_text(json.dumps(references, indent=1).replace("\n    ", " ").replace("\n   ]", " ]") + "\n")
