"""Trees of sources are kept while the tests of the house run, and no longer: they take 150 MB."""

from collections.abc import Iterator

import pytest

from tests.support.sources import nodes_of


@pytest.fixture(scope="package", autouse=True)
def trees() -> Iterator[None]:
    yield
    nodes_of.cache_clear()
