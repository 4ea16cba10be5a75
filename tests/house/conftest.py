"""Trees of sources are kept while the tests of the house run, and no longer: they take 150 MB."""

import gc
from collections.abc import Iterator

import pytest

from tests.support.sources import nodes_of


@pytest.fixture(scope="package", autouse=True)
def trees() -> Iterator[None]:
    gc.disable()  # it would go through more than a million nodes, again and again, for nothing
    yield
    nodes_of.cache_clear()
    gc.enable()
