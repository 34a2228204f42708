"""The gear in space and its map along the face, as the page shows them."""
